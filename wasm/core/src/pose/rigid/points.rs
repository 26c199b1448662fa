//! Places at which the energy is measured: nodes of the quadrature, and triangles that are about to fold.

use glam::{DMat2, DVec2};

use super::{
    energy::{Law, Local, energy},
    freedom::{Freedom, Parts, Request},
};
use crate::pose::numeric::{Pattern, Slot};

/// Places with the sites that move them.
#[derive(Debug, Clone, Default)]
pub(super) struct Points {
    law: Law,
    points: Vec<Point>,
    terms: Vec<Term>,
    /// Where the block of each pair of terms with unknowns is.
    slots: Vec<Slot>,
}

#[derive(Debug, Clone)]
struct Point {
    area: f64,
    /// End of its terms, and of its slots; they begin at the ends of the point before.
    end: u32,
    slots: u32,
}

/// What the map does at a place.
#[derive(Debug, Clone, Copy)]
pub(super) struct Deformed {
    pub(super) jacobian: DMat2,
    /// The regularisation ε of the energy there; 0 unless the place may fold.
    pub(super) epsilon: f64,
}

/// The influence of a site at a place.
#[derive(Debug, Clone)]
struct Term {
    site: u32,
    /// Number of unknowns of the site, and the first of them.
    count: u32,
    first: u32,
    /// Factors of the site's parts in the place.
    place: [f64; 3],
    /// The same in the Jacobian: J = Σ part ⊗ factor.
    parts: [DVec2; 3],
    /// Factors of the unknowns in the Jacobian.
    columns: [DVec2; 3],
}

/// The sites' unknowns, as points refer to them.
pub(super) struct Layout<'a> {
    pub(super) freedom: &'a [Freedom],
    pub(super) group: &'a [Option<u32>],
    pub(super) pattern: &'a Pattern,
}

impl Points {
    /// No places yet.
    pub(super) fn new(law: Law) -> Self {
        Self { law, ..Self::default() }
    }

    /// Adds a place by its terms: site, factors of its parts in the place, and in the Jacobian.
    pub(super) fn add(
        &mut self,
        layout: &Layout<'_>,
        area: f64,
        terms: impl Iterator<Item = (u32, [f64; 3], [DVec2; 3])>,
    ) {
        let start = self.terms.len();
        for (site, place, parts) in terms {
            let (mut columns, mut count) = ([DVec2::ZERO; 3], 0);
            for factors in layout.freedom[site as usize].factors() {
                columns[count] = (0..3).map(|k| factors[k] * parts[k]).sum();
                count += 1;
            }
            let first = layout.group[site as usize].map_or(0, |group| layout.pattern.first(group as usize) as u32);
            self.terms.push(Term { site, count: count as u32, first, place, parts, columns });
        }
        let groups = self.terms[start..].iter().filter_map(|term| layout.group[term.site as usize]);
        for (at, a) in groups.clone().enumerate() {
            self.slots.extend(groups.clone().take(at + 1).map(|b| layout.pattern.slot(a, b)));
        }
        self.points.push(Point { area, end: self.terms.len() as u32, slots: self.slots.len() as u32 });
    }

    pub(super) fn clear(&mut self) {
        self.points.clear();
        self.terms.clear();
        self.slots.clear();
    }

    fn each<T>(&self, mut visit: impl FnMut(&Point, &[Term]) -> T) -> impl Iterator<Item = T> {
        let mut start = 0;
        self.points.iter().map(move |point| {
            let terms = &self.terms[start..point.end as usize];
            start = point.end as usize;
            visit(point, terms)
        })
    }

    /// The Jacobian at each place, or its change if `parts` are changes.
    pub(super) fn jacobians(&self, parts: &[Parts]) -> Vec<DMat2> {
        self.each(|_, terms| jacobian(terms, parts)).collect()
    }

    /// Each place, or its change if `parts` are changes.
    pub(super) fn places(&self, parts: &[Parts]) -> Vec<DVec2> {
        let moved = |term: &Term| (0..3).map(|k| term.place[k] * parts[term.site as usize][k]).sum::<DVec2>();
        self.each(|_, terms| terms.iter().map(moved).sum()).collect()
    }

    pub(super) fn energy(&self, deformed: &[Deformed], request: &Request<'_>) -> f64 {
        let of =
            |((area, unscale), at): ((f64, f64), &Deformed)| area * energy(unscale * at.jacobian, at.epsilon, self.law);
        self.each(|point, terms| (point.area, request.unscale(terms))).zip(deformed).map(of).sum()
    }

    /// Adds minus the gradient with respect to each unknown.
    pub(super) fn add_forces(&self, deformed: &[Deformed], request: &Request<'_>, forces: &mut [f64]) {
        let mut deformed = deformed.iter();
        let visit = |point: &Point, terms: &[Term]| {
            let (unscale, at) = (request.unscale(terms), deformed.next().expect("one for each"));
            let gradient = unscale * Local::gradient(unscale * at.jacobian, at.epsilon, self.law);
            terms.iter().for_each(|term| term.add_force(point.area, gradient, request, forces));
        };
        self.each(visit).for_each(drop);
    }

    /// Adds the second derivatives, and the forces once the driven parts have moved.
    pub(super) fn assemble(
        &self,
        values: &mut [f64],
        deformed: &[Deformed],
        driven: Option<&[Parts]>,
        request: &Request<'_>,
        is_projected: bool,
        forces: &mut [f64],
    ) {
        let mut first_slot = 0;
        let mut deformed = deformed.iter();
        let visit = |point: &Point, terms: &[Term]| {
            let mut slots = self.slots[first_slot..point.slots as usize].iter();
            first_slot = point.slots as usize;
            let (unscale, at) = (request.unscale(terms), deformed.next().expect("one for each"));
            let local = Local::of(unscale * at.jacobian, at.epsilon, self.law, is_projected);
            let mut gradient = unscale * local.gradient;
            if let Some(driven) = driven {
                gradient += unscale * unscale * local.change(jacobian(terms, driven));
            }
            let weight = point.area * unscale * unscale;
            let hessian = local.hessian.map(|row| row.map(|block| weight * block));
            for (a, term) in terms.iter().enumerate().filter(|(_, term)| term.count > 0) {
                let of_a = term.columns(request);
                term.add_force(point.area, gradient, request, forces);
                let mut rows = [[DMat2::ZERO; 2]; 3];
                for (row, c) in rows.iter_mut().zip(of_a) {
                    *row = [0, 1].map(|q| c.x * hessian[0][q] + c.y * hessian[1][q]);
                }
                for other in terms[..=a].iter().filter(|term| term.count > 0) {
                    let slot = slots.next().expect("a slot for each pair");
                    let of_b = other.columns(request);
                    if of_a.len() == 3 && of_b.len() == 3 {
                        slot.add_whole(values, &rows, &other.columns);
                        continue;
                    }
                    for (k, row) in rows[..of_a.len()].iter().enumerate() {
                        for (l, c) in of_b.iter().enumerate() {
                            slot.add(values, [k, l], c.x * row[0] + c.y * row[1]);
                        }
                    }
                }
            }
        };
        self.each(visit).for_each(drop);
    }
}

impl Request<'_> {
    /// Reciprocal of the scale that handles request at a place.
    fn unscale(&self, terms: &[Term]) -> f64 {
        let scale = |scales: &[f64]| terms.iter().map(|term| term.place[0] * scales[term.site as usize]).sum::<f64>();
        self.scales.map_or(1.0, |scales| 1.0 / scale(scales))
    }
}

impl Term {
    fn add_force(&self, area: f64, gradient: DMat2, request: &Request<'_>, forces: &mut [f64]) {
        let first = self.first as usize;
        for (k, &column) in self.columns(request).iter().enumerate() {
            let force = -area * (gradient * column);
            forces[first + 2 * k] += force.x;
            forces[first + 2 * k + 1] += force.y;
        }
    }

    /// The factors of the unknowns, unless they are set.
    fn columns(&self, request: &Request<'_>) -> &[DVec2] {
        let is_set = self.count == 2 && !request.is_free[self.site as usize];
        &self.columns[..if is_set { 0 } else { self.count as usize }]
    }
}

fn jacobian(terms: &[Term], parts: &[Parts]) -> DMat2 {
    terms.iter().fold(DMat2::ZERO, |sum, term| {
        let ([place, x, y], [of_place, of_x, of_y]) = (parts[term.site as usize], term.parts);
        DMat2::from_cols(
            sum.x_axis + (of_place.x * place + of_x.x * x + of_y.x * y),
            sum.y_axis + (of_place.y * place + of_x.y * x + of_y.y * y),
        )
    })
}
