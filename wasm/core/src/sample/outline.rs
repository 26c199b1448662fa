//! Samples along the outline: all its corners, and points between them no farther apart than the spacing.

use glam::DVec2;

use crate::{domain::Domain, locate::ON_OUTLINE};

/// The outline's samples while more are added.
pub(super) struct Outline {
    pub(super) vertices: Vec<DVec2>,
    /// Pieces of the outline between samples.
    pub(super) segments: Vec<[usize; 2]>,
    /// Samples along each ring.
    pub(super) rings: Vec<Vec<u32>>,
    /// Sites that became samples of the outline, or coincide with one.
    on_outline: Vec<(DVec2, u32)>,
}

impl Outline {
    /// Samples a domain's outline. A site that lies on the outline becomes a sample of it.
    pub(super) fn new(domain: &Domain, sites: &[DVec2], spacing: f64) -> Self {
        let mut outline =
            Self { vertices: Vec::new(), segments: Vec::new(), rings: Vec::new(), on_outline: Vec::new() };
        for ring in domain.rings() {
            let start = outline.vertices.len();
            for (a, b) in crate::domain::edges(ring) {
                outline.edge(a, b, sites, spacing);
            }
            let end = outline.vertices.len();
            outline.segments.extend((start..end).map(|i| [i, if i + 1 == end { start } else { i + 1 }]));
            outline.rings.push((start as u32..end as u32).collect());
        }
        outline
    }

    /// Adds the samples of an edge, without its end.
    fn edge(&mut self, a: DVec2, b: DVec2, sites: &[DVec2], spacing: f64) {
        let (along, length) = (b - a, a.distance(b));
        let on_edge = |site: DVec2| {
            let t = (site - a).dot(along) / (length * length);
            let close = (-ON_OUTLINE..length + ON_OUTLINE).contains(&(t * length))
                && (site - a).perp_dot(along).abs() <= ON_OUTLINE * length;
            close.then_some((t.clamp(0.0, 1.0), site))
        };
        let mut stops: Vec<(f64, DVec2)> = sites.iter().filter_map(|&site| on_edge(site)).collect();
        stops.sort_by(|(t, _), (u, _)| t.total_cmp(u));
        let mut from = 0.0;
        self.vertices.push(a);
        for (t, site) in stops {
            if (t * length) < ON_OUTLINE {
                self.on_outline.push((site, self.vertices.len() as u32 - 1));
            } else if (1.0 - t) * length >= ON_OUTLINE {
                self.between(a, b, (from, t), spacing);
                self.vertices.push(a + along * t);
                self.on_outline.push((site, self.vertices.len() as u32 - 1));
                from = t;
            }
        }
        self.between(a, b, (from, 1.0), spacing);
    }

    /// Evenly spaced samples between two parameters of an edge, both excluded.
    fn between(&mut self, a: DVec2, b: DVec2, (from, to): (f64, f64), spacing: f64) {
        let pieces = ((to - from) * a.distance(b) / spacing).ceil().max(1.0);
        let at = |i: u32| a + (b - a) * (from + (to - from) * f64::from(i) / pieces);
        self.vertices.extend((1..pieces as u32).map(at));
    }

    /// The sample of a site: one of the outline, or a new one.
    pub(super) fn place_site(&mut self, site: DVec2) -> u32 {
        if let Some(&(_, vertex)) = self.on_outline.iter().find(|&&(p, _)| p == site) {
            return vertex;
        }
        self.vertices.push(site);
        self.vertices.len() as u32 - 1
    }
}
