//! The benchmark cases: six scenes after Table I of the paper, and a gingerbread figure after Table II.
//!
//! The paper's pictures are not available. These resemble them in shape, and have the same numbers of bars, points and
//! samples. The cases of Table I ask for the paper's numbers of virtual sites, so Algorithm 1 has similar work.

use c2warp::{
    Error, Picture,
    project::{DomainSpec, Handle, ImageRef, Project, Rotation},
};
use glam::DVec2;

use crate::{
    drag::Drag,
    limbs::{Limb, disc, draw, limb},
};

/// A picture and a project for it.
#[derive(Debug, Clone)]
pub struct Case {
    /// The project, with handles at rest.
    pub project: Project,
    rgba: Vec<u8>,
}

/// A row of the paper's Table I.
#[derive(Debug, Clone, Copy)]
pub struct Table1Row {
    /// The name of the scene.
    pub name: &'static str,
    /// |H_b|: the number of bar handles.
    pub bars: usize,
    /// |H_p|: the number of point handles.
    pub points: usize,
    /// |V|: the number of virtual handles.
    pub virtual_sites: u32,
    /// |S|: the number of samples.
    pub samples: u32,
    /// t_rd: time for the regions.
    pub regions_ms: f64,
    /// t_w: time for the weights.
    pub weights_ms: f64,
}

/// A row of the paper's Table II.
#[derive(Debug, Clone, Copy)]
pub struct Table2Row {
    /// The number of vertices.
    pub samples: u32,
    /// Time of bounded biharmonic weights, if they could be computed.
    pub biharmonic_ms: Option<f64>,
    /// Time of the paper's method.
    pub paper_ms: f64,
}

/// Table I of the paper.
pub const TABLE_1: [Table1Row; 6] = [
    table_1_row("Tower", [12, 0, 113], 7_834, 3_750.0, 13.0),
    table_1_row("Wolf", [4, 2, 1], 6_694, 20.0, 1.0),
    table_1_row("Portrait", [7, 0, 36], 9_438, 380.0, 6.0),
    table_1_row("Alligator", [0, 3, 3], 9_456, 409.0, 2.0),
    table_1_row("Rabbit", [0, 4, 16], 22_972, 1_700.0, 434.0),
    table_1_row("Road", [3, 3, 124], 13_212, 3_180.0, 2.0),
];

/// Table II of the paper.
pub const TABLE_2: [Table2Row; 3] = [
    Table2Row { samples: 627, biharmonic_ms: Some(818.0), paper_ms: 24.0 },
    Table2Row { samples: 31_325, biharmonic_ms: Some(8_691.0), paper_ms: 110.0 },
    Table2Row { samples: 619_649, biharmonic_ms: None, paper_ms: 20_796.0 },
];

const fn table_1_row(
    name: &'static str,
    [bars, points, virtual_sites]: [u32; 3],
    samples: u32,
    regions_ms: f64,
    weights_ms: f64,
) -> Table1Row {
    Table1Row { name, bars: bars as usize, points: points as usize, virtual_sites, samples, regions_ms, weights_ms }
}

impl Case {
    /// Returns a case whose domain is the union of limbs without holes.
    fn on_limbs((width, height): (u32, u32), limbs: &[Limb], holes: &[Limb], handles: &[(f64, f64)]) -> Self {
        Self::new(width, height, draw(width, height, limbs, holes), handles)
    }

    /// Returns a case whose domain is the whole picture.
    fn on_rectangle((width, height): (u32, u32), handles: &[(f64, f64)]) -> Self {
        let mut case = Self::new(width, height, vec![u8::MAX; width as usize * height as usize * 4], handles);
        case.project.domain = Some(DomainSpec::Image);
        case
    }

    fn new(width: u32, height: u32, rgba: Vec<u8>, handles: &[(f64, f64)]) -> Self {
        let mut project = Project::new(ImageRef::new("draw.png", width, height));
        project.handles = handles.iter().enumerate().map(|(id, &rest)| handle(id, rest.into())).collect();
        Self { project, rgba }
    }

    /// Adds straight bars.
    fn with_bars(mut self, bars: &[[(f64, f64); 2]]) -> Self {
        let bar = |(at, ends): (usize, &[(f64, f64); 2])| Handle::bar(format!("b{at}"), *ends).turned(Rotation::Auto);
        self.project.handles.extend(bars.iter().enumerate().map(bar));
        self
    }

    /// Returns the project with this number of samples and at least this number of virtual sites.
    #[must_use]
    pub fn project(&self, samples: u32, virtual_sites: u32) -> Project {
        let mut project = self.project.clone();
        project.samples = samples;
        project.pose.density = virtual_sites;
        project
    }

    /// Returns the picture.
    ///
    /// # Errors
    /// None for the cases of this module.
    pub fn picture(&self) -> Result<Picture<'_>, Error> {
        Picture::new(self.project.image.width, self.project.image.height, &self.rgba)
    }
}

/// Returns a point handle at rest.
#[must_use]
pub fn handle(id: usize, rest: DVec2) -> Handle {
    Handle::point(format!("h{id}"), rest)
}

/// Returns the cases of Table I, in its order.
#[must_use]
pub fn table_1() -> [Case; 6] {
    [tower(), wolf(), portrait(), alligator(), rabbit(), road()]
}

/// A tapering tower with storeys, battlements and a gate. Bars follow both sides.
fn tower() -> Case {
    let mut limbs =
        vec![limb((250.0, 730.0), 130.0, (250.0, 200.0), 70.0), limb((90.0, 760.0), 30.0, (410.0, 760.0), 30.0)];
    limbs.extend([180.0, 380.0, 560.0].map(|y| limb((165.0 - y / 10.0, y), 14.0, (335.0 + y / 10.0, y), 14.0)));
    limbs.extend(
        [0, 1, 2, 3]
            .map(|i| limb((175.0 + 50.0 * f64::from(i), 110.0), 10.0, (175.0 + 50.0 * f64::from(i), 170.0), 12.0)),
    );
    let gate =
        [limb((250.0, 830.0), 36.0, (250.0, 690.0), 36.0), disc((250.0, 290.0), 16.0), disc((250.0, 470.0), 18.0)];
    let storeys = [230.0, 320.0, 410.0, 500.0, 590.0, 700.0];
    let side = |x: f64, y: f64, lean: f64| [(x - lean * (y - 30.0), y - 30.0), (x - lean * (y + 30.0), y + 30.0)];
    let bars: Vec<_> =
        storeys.iter().flat_map(|&y| [side(196.0, y, 1.0 / 16.0), side(304.0, y, -1.0 / 16.0)]).collect();
    Case::on_limbs((500, 820), &limbs, &gate, &[]).with_bars(&bars)
}

/// A four-legged animal from the side, with bars along its legs and points on snout and tail.
fn wolf() -> Case {
    let limbs = [
        limb((240.0, 230.0), 75.0, (500.0, 240.0), 62.0),
        limb((230.0, 220.0), 62.0, (140.0, 120.0), 48.0),
        limb((140.0, 125.0), 42.0, (55.0, 165.0), 16.0),
        limb((150.0, 90.0), 22.0, (165.0, 45.0), 5.0),
        limb((118.0, 92.0), 20.0, (112.0, 50.0), 5.0),
        limb((540.0, 230.0), 28.0, (665.0, 320.0), 10.0),
        limb((215.0, 280.0), 36.0, (190.0, 450.0), 15.0),
        limb((275.0, 280.0), 34.0, (290.0, 450.0), 15.0),
        limb((490.0, 270.0), 38.0, (450.0, 450.0), 15.0),
        limb((535.0, 260.0), 36.0, (560.0, 450.0), 15.0),
    ];
    let bars = [
        [(210.0, 330.0), (190.0, 450.0)],
        [(280.0, 330.0), (290.0, 450.0)],
        [(480.0, 330.0), (450.0, 450.0)],
        [(545.0, 330.0), (560.0, 450.0)],
    ];
    Case::on_limbs((700, 500), &limbs, &[], &[(90.0, 150.0), (640.0, 302.0)]).with_bars(&bars)
}

/// A whole picture, with bars along brows, eyes, mouth and shoulders.
fn portrait() -> Case {
    let bars = [
        [(205.0, 260.0), (265.0, 252.0)],
        [(335.0, 252.0), (395.0, 260.0)],
        [(215.0, 300.0), (260.0, 300.0)],
        [(340.0, 300.0), (385.0, 300.0)],
        [(250.0, 430.0), (350.0, 430.0)],
        [(80.0, 690.0), (200.0, 620.0)],
        [(400.0, 620.0), (520.0, 690.0)],
    ];
    Case::on_rectangle((600, 780), &[]).with_bars(&bars)
}

/// A long, low animal, with handles on snout, back and tail.
fn alligator() -> Case {
    let limbs = [
        limb((330.0, 180.0), 62.0, (520.0, 190.0), 55.0),
        limb((330.0, 170.0), 50.0, (200.0, 160.0), 42.0),
        limb((200.0, 165.0), 34.0, (40.0, 150.0), 14.0),
        limb((200.0, 185.0), 28.0, (60.0, 205.0), 10.0),
        limb((540.0, 190.0), 50.0, (720.0, 230.0), 26.0),
        limb((720.0, 230.0), 26.0, (870.0, 170.0), 5.0),
        limb((330.0, 220.0), 26.0, (290.0, 310.0), 14.0),
        limb((380.0, 225.0), 26.0, (390.0, 315.0), 14.0),
        limb((500.0, 220.0), 28.0, (470.0, 315.0), 14.0),
        limb((560.0, 220.0), 26.0, (590.0, 315.0), 14.0),
    ];
    Case::on_limbs((900, 360), &limbs, &[], &[(60.0, 155.0), (430.0, 180.0), (840.0, 182.0)])
}

/// A sitting animal with long ears, with handles on ears, belly and paws.
fn rabbit() -> Case {
    let limbs = [
        limb((300.0, 520.0), 150.0, (300.0, 420.0), 115.0),
        disc((300.0, 290.0), 98.0),
        limb((260.0, 220.0), 34.0, (215.0, 50.0), 24.0),
        limb((340.0, 220.0), 34.0, (385.0, 50.0), 24.0),
        limb((230.0, 620.0), 60.0, (160.0, 670.0), 38.0),
        limb((370.0, 620.0), 60.0, (440.0, 670.0), 38.0),
        disc((435.0, 480.0), 44.0),
    ];
    Case::on_limbs((600, 740), &limbs, &[], &[(217.0, 60.0), (383.0, 60.0), (300.0, 470.0), (170.0, 668.0)])
}

/// A whole picture of a road. Bars follow both kerbs and the middle, points lie next to it.
fn road() -> Case {
    let bars = [[(120.0, 560.0), (390.0, 240.0)], [(680.0, 560.0), (430.0, 240.0)], [(400.0, 560.0), (408.0, 300.0)]];
    Case::on_rectangle((800, 600), &[(120.0, 200.0), (410.0, 120.0), (690.0, 200.0)]).with_bars(&bars)
}

/// Returns the figure of Table II. Its six point handles need no virtual site.
#[must_use]
pub fn gingerbread() -> Case {
    let limbs = [
        disc((500.0, 190.0), 150.0),
        limb((500.0, 400.0), 120.0, (500.0, 600.0), 150.0),
        limb((460.0, 420.0), 85.0, (180.0, 430.0), 75.0),
        limb((540.0, 420.0), 85.0, (820.0, 430.0), 75.0),
        limb((440.0, 640.0), 95.0, (330.0, 870.0), 88.0),
        limb((560.0, 640.0), 95.0, (670.0, 870.0), 88.0),
    ];
    let handles = [(500.0, 190.0), (180.0, 430.0), (820.0, 430.0), (500.0, 500.0), (330.0, 870.0), (670.0, 870.0)];
    Case::on_limbs((1000, 1000), &limbs, &[], &handles)
}

/// Returns another handle for the gingerbread figure, on a knee.
#[must_use]
pub fn knee_handle() -> Handle {
    handle(6, DVec2::new(615.0, 750.0))
}

/// Returns a drag of the left hand above the head.
#[must_use]
pub fn raised_hand() -> Drag {
    Drag { handle: 1, to: DVec2::new(420.0, 60.0) }
}

/// Returns points that are spread evenly over a picture, by Roberts's R₂ sequence (multiples of powers of the plastic
/// number).
pub fn spread(size: DVec2) -> impl Iterator<Item = DVec2> {
    let at = |i: u32| DVec2::new(0.754_877_666_246_692_7, 0.569_840_290_998_053_2) * f64::from(i);
    (1..).map(move |i| at(i).fract() * size)
}
