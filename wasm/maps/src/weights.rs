//! Tables of weights at points: of all sites (eq. 2), or of one handle.
//!
//! The weight of a handle is the fraction of its motion that a point follows in the harmonic mode: the weights of its
//! own sites, and those of virtual sites times ϖ, the share that they take from it (eq. 4). Over all handles they sum
//! to 1.
//!
//! Cost: about two microseconds per point. Rows are written one after another, so memory does not depend on the number
//! of points.

use std::io::{self, Write};

use c2warp::{Solution, glam::DVec2, project::Project};

use crate::{WeightsError, npy, number::decimal, places::Places};

/// Bytes of a number in a table.
const NUMBER_BYTES: u64 = 8;
/// Points between two reports of progress.
const POINTS_PER_REPORT: usize = 4096;

/// The weights of a table.
#[derive(Debug, Clone, PartialEq)]
pub enum Columns {
    /// The weights of all sites.
    Sites,
    /// The weight of one handle.
    Handle {
        /// Its name.
        name: String,
        /// For each site, its share of the handle's motion.
        shares: Vec<f64>,
    },
}

/// The format of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TableFormat {
    /// A row for each weight above 0.
    Csv,
    /// An array with all weights.
    Npy,
}

/// The weights of a solved project.
#[derive(Debug, Clone)]
pub struct Weights<'a> {
    solution: &'a Solution,
    project: &'a Project,
    columns: Columns,
}

impl<'a> Weights<'a> {
    /// The weights of all sites, or of the handle with a name.
    ///
    /// # Errors
    /// [`WeightsError::NoHandle`] for an unknown name.
    ///
    /// # Panics
    /// If the solution belongs to another project.
    pub fn new(solution: &'a Solution, project: &'a Project, handle: Option<&str>) -> Result<Self, WeightsError> {
        let columns = match handle {
            None => Columns::Sites,
            Some(name) => {
                Columns::Handle { name: name.to_owned(), shares: shares(solution, handle_index(project, name)?) }
            }
        };
        Ok(Self { solution, project, columns })
    }

    /// Checks the name of a handle before a solve.
    ///
    /// # Errors
    /// The errors of [`new`](Self::new).
    pub fn check_handle(project: &Project, name: &str) -> Result<(), WeightsError> {
        handle_index(project, name).map(|_| ())
    }

    /// The weights of the mesh's vertices, for one handle.
    #[must_use]
    pub fn at_vertices(&self) -> Vec<f64> {
        let rows = self.solution.weights();
        (0..self.solution.vertices().len()).map(|vertex| self.sum(rows.row(vertex))).collect()
    }

    /// The shape of an array of all weights: the axes of the points, then the sites.
    #[must_use]
    pub fn shape(&self, places: &Places) -> Vec<usize> {
        let mut shape = places.shape();
        if self.columns == Columns::Sites {
            shape.push(self.solution.sites().len());
        }
        shape
    }

    /// Rejects an array of more than `most` bytes.
    ///
    /// # Errors
    /// [`WeightsError::TooLarge`].
    pub fn check_size(&self, places: &Places, most: u64) -> Result<(), WeightsError> {
        let shape = self.shape(places);
        let bytes = shape.iter().fold(NUMBER_BYTES, |bytes, &side| bytes.saturating_mul(side as u64));
        let advice = match self.columns {
            Columns::Sites => "take fewer points, or one handle",
            Columns::Handle { .. } => "take fewer points",
        };
        if bytes > most { Err(WeightsError::TooLarge { shape, bytes, advice }) } else { Ok(()) }
    }

    /// Writes a table. `on_progress` receives the completed fraction.
    ///
    /// # Errors
    /// The errors of the output.
    pub fn write(
        &self,
        places: &Places,
        format: TableFormat,
        to: &mut dyn Write,
        on_progress: &mut dyn FnMut(f64),
    ) -> io::Result<()> {
        let mut on_point = |point: usize| {
            if point.is_multiple_of(POINTS_PER_REPORT) {
                on_progress(point as f64 / places.count() as f64);
            }
        };
        match format {
            TableFormat::Csv => self.write_csv(places, to, &mut on_point),
            TableFormat::Npy => self.write_npy(places, to, &mut on_point),
        }
    }

    /// Writes an array. Points outside the domain have zeros.
    fn write_npy(&self, places: &Places, to: &mut dyn Write, on_point: &mut dyn FnMut(usize)) -> io::Result<()> {
        to.write_all(&npy::header(&self.shape(places)))?;
        let mut row = vec![0.0; self.solution.sites().len()];
        for point in 0..places.count() {
            on_point(point);
            let p = places.at(point);
            match self.columns {
                Columns::Handle { .. } => to.write_all(&self.handle_at(p).to_le_bytes())?,
                Columns::Sites => {
                    row.fill(0.0);
                    for (site, weight) in self.at(p) {
                        row[site] = weight;
                    }
                    for weight in &row {
                        to.write_all(&weight.to_le_bytes())?;
                    }
                }
            }
        }
        Ok(())
    }

    fn write_csv(&self, places: &Places, to: &mut dyn Write, on_point: &mut dyn FnMut(usize)) -> io::Result<()> {
        let mut table = csv::Writer::from_writer(to);
        match self.columns {
            Columns::Sites => {
                table
                    .write_record(["point", "site", "kind", "handle", "site_x", "site_y", "weight"])
                    .map_err(io_error)?;
            }
            Columns::Handle { .. } => table.write_record(["point", "x", "y", "handle", "weight"]).map_err(io_error)?,
        }
        for point in 0..places.count() {
            on_point(point);
            let p = places.at(point);
            let number = point.to_string();
            match &self.columns {
                Columns::Handle { name, .. } => {
                    let weight = self.handle_at(p);
                    if weight > 0.0 {
                        let record = [&number, &decimal(p.x), &decimal(p.y), name, &decimal(weight)];
                        table.write_record(record).map_err(io_error)?;
                    }
                }
                Columns::Sites => {
                    for (site, weight) in self.at(p).filter(|&(_, weight)| weight > 0.0) {
                        let [kind, handle, x, y] = self.site_cells(site);
                        let record = [&number, &site.to_string(), &kind, &handle, &x, &y, &decimal(weight)];
                        table.write_record(record).map_err(io_error)?;
                    }
                }
            }
        }
        table.flush()
    }

    /// Writes the sites, whose order is that of the last index of an array: `site,kind,handle,site_x,site_y`.
    ///
    /// # Errors
    /// The errors of the output.
    pub fn write_sites(&self, to: &mut dyn Write) -> io::Result<()> {
        let mut table = csv::Writer::from_writer(to);
        table.write_record(["site", "kind", "handle", "site_x", "site_y"]).map_err(io_error)?;
        for site in 0..self.solution.sites().len() {
            let [kind, handle, x, y] = self.site_cells(site);
            table.write_record([&site.to_string(), &kind, &handle, &x, &y]).map_err(io_error)?;
        }
        table.flush()
    }

    /// The kind of a site, its handle, and its position. The sites of a fixed boundary are real, but belong to no
    /// handle.
    fn site_cells(&self, site: usize) -> [String; 4] {
        let site = &self.solution.sites()[site];
        let kind = if site.kind.is_real() { "real" } else { "virtual" };
        let handle = site.kind.handle().map_or("", |handle| self.project.handles[handle].id.as_str());
        [kind.to_owned(), handle.to_owned(), decimal(site.rest.x), decimal(site.rest.y)]
    }

    fn at(&self, p: DVec2) -> impl Iterator<Item = (usize, f64)> {
        self.solution.weights_at(p).unwrap_or_default().into_iter()
    }

    fn handle_at(&self, p: DVec2) -> f64 {
        self.sum(self.at(p))
    }

    fn sum(&self, weights: impl Iterator<Item = (usize, f64)>) -> f64 {
        match &self.columns {
            Columns::Sites => weights.map(|(_, weight)| weight).sum(),
            Columns::Handle { shares, .. } => weights.map(|(site, weight)| weight * shares[site]).sum(),
        }
    }
}

fn handle_index(project: &Project, name: &str) -> Result<usize, WeightsError> {
    let handles = &project.handles;
    handles.iter().position(|handle| handle.id == name).ok_or_else(|| WeightsError::NoHandle {
        name: name.to_owned(),
        names: handles.iter().map(|handle| handle.id.clone()).collect(),
    })
}

fn shares(solution: &Solution, handle: usize) -> Vec<f64> {
    let sites = solution.sites();
    let is_own = |site: usize| sites[site].kind.handle() == Some(handle);
    let share = |site| solution.harmonic_weights(site).filter(|&(real, _)| is_own(real)).map(|(_, share)| share).sum();
    (0..sites.len()).map(share).collect()
}

/// `From<csv::Error>` would lose the kind of error.
fn io_error(reason: csv::Error) -> io::Error {
    match reason.into_kind() {
        csv::ErrorKind::Io(reason) => reason,
        reason => io::Error::other(format!("{reason:?}")),
    }
}
