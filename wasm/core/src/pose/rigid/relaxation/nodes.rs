//! The nodes of the quadrature in the layout of the relaxation: one after another, each with its terms in a row.

use glam::DVec2;

use super::{super::quadrature, Freedom};
use crate::rank::sort_by_rank;

/// A node. Lengths are in [units](super::Relaxation::unit), except for areas.
#[derive(Debug, Clone)]
pub(super) struct Node {
    pub(super) at: DVec2,
    /// Its area in square pixels, times the factor of its stiffness.
    pub(super) area: f64,
    /// End of its terms; they begin at the end of the previous node's.
    end: u32,
    /// Number of its terms that belong to sites without freedom; these come first.
    pub(super) fixed: u32,
}

/// The influence of a site at a node.
#[derive(Debug, Clone)]
pub(super) struct Term {
    pub(super) site: u32,
    pub(super) weight: f64,
    pub(super) gradient: DVec2,
}

/// The nodes at which some site is free.
#[derive(Debug, Clone)]
pub(super) struct Nodes {
    nodes: Vec<Node>,
    terms: Vec<Term>,
}

impl Nodes {
    pub(super) fn new(all: Vec<quadrature::Node>, factors: &[f64], freedom: &[Freedom], unit: f64) -> Self {
        let (mut nodes, mut terms) = (Vec::new(), Vec::new());
        for (quadrature::Node { at, area, mut influences }, factor) in all.into_iter().zip(factors) {
            sort_by_rank(&mut influences, |one| [(freedom[one.site] != Freedom::None).into(), 0]);
            let fixed = influences.iter().filter(|one| freedom[one.site] == Freedom::None).count();
            if fixed < influences.len() {
                terms.extend(influences.iter().map(|one| Term {
                    site: one.site as u32,
                    weight: one.weight,
                    gradient: unit * one.gradient,
                }));
                let area = area * factor;
                nodes.push(Node { at: at / unit, area, end: terms.len() as u32, fixed: fixed as u32 });
            }
        }
        Self { nodes, terms }
    }

    /// Each node with its terms.
    pub(super) fn iter(&self) -> impl ExactSizeIterator<Item = (&Node, &[Term])> {
        let mut start = 0;
        self.nodes.iter().map(move |node| {
            let terms = &self.terms[start..node.end as usize];
            start = node.end as usize;
            (node, terms)
        })
    }
}

impl Term {
    /// Derivatives of the Jacobian's columns with respect to each part, at an offset from the site.
    pub(super) fn of_parts(&self, offset: DVec2) -> [DVec2; 3] {
        let Self { weight, gradient, .. } = *self;
        [gradient, offset.x * gradient + DVec2::new(weight, 0.0), offset.y * gradient + DVec2::new(0.0, weight)]
    }
}
