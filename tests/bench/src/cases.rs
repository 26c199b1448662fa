//! The scenes that are solved: like the paper's of Table I, and its gingerbread figure of Table II.
//!
//! The paper's pictures are not to be had; these resemble them in shape, and have as many bars, points and samples. So that
//! Algorithm 1 has about as much to do, the scenes of Table I ask for as many virtual sites as the paper's had.

use c2warp::{
    Error, Picture,
    project::{DomainSpec, Handle, ImageRef, Project, Rotation, Shape},
};
use glam::DVec2;

use crate::drawing::{Limb, drawn, limb, spot};

/// A picture and what is to be solved on it.
#[derive(Debug, Clone)]
pub struct Scene {
    /// The project; its handles are at rest.
    pub project: Project,
    rgba: Vec<u8>,
}

/// A row of the paper's Table I.
#[derive(Debug, Clone, Copy)]
pub struct PaperScene {
    /// The scene's name.
    pub name: &'static str,
    /// |H_b|, its bar handles.
    pub bars: usize,
    /// |H_p|, its point handles.
    pub points: usize,
    /// |V|, its virtual handles.
    pub virtual_sites: u32,
    /// |S|, its samples.
    pub samples: u32,
    /// t_rd, for the regions.
    pub regions_ms: f64,
    /// t_w, for the weights.
    pub weights_ms: f64,
}

/// A row of the paper's Table II.
#[derive(Debug, Clone, Copy)]
pub struct PaperResolution {
    /// Number of vertices.
    pub samples: u32,
    /// Bounded biharmonic weights, where they could be computed.
    pub biharmonic_ms: Option<f64>,
    /// The paper's method.
    pub paper_ms: f64,
}

/// Table I of the paper.
pub const TABLE_1: [PaperScene; 6] = [
    paper_scene("Tower", [12, 0, 113], 7_834, 3_750.0, 13.0),
    paper_scene("Wolf", [4, 2, 1], 6_694, 20.0, 1.0),
    paper_scene("Portrait", [7, 0, 36], 9_438, 380.0, 6.0),
    paper_scene("Alligator", [0, 3, 3], 9_456, 409.0, 2.0),
    paper_scene("Rabbit", [0, 4, 16], 22_972, 1_700.0, 434.0),
    paper_scene("Road", [3, 3, 124], 13_212, 3_180.0, 2.0),
];

/// Table II of the paper.
pub const TABLE_2: [PaperResolution; 3] = [
    PaperResolution { samples: 627, biharmonic_ms: Some(818.0), paper_ms: 24.0 },
    PaperResolution { samples: 31_325, biharmonic_ms: Some(8_691.0), paper_ms: 110.0 },
    PaperResolution { samples: 619_649, biharmonic_ms: None, paper_ms: 20_796.0 },
];

const fn paper_scene(
    name: &'static str,
    [bars, points, virtual_sites]: [u32; 3],
    samples: u32,
    regions_ms: f64,
    weights_ms: f64,
) -> PaperScene {
    PaperScene { name, bars: bars as usize, points: points as usize, virtual_sites, samples, regions_ms, weights_ms }
}

impl Scene {
    /// A scene on what the limbs cover.
    fn on_limbs((width, height): (u32, u32), limbs: &[Limb], holes: &[Limb], handles: &[(f64, f64)]) -> Self {
        Self::new(width, height, drawn(width, height, limbs, holes), handles)
    }

    /// A scene on the whole of a picture.
    fn on_rectangle((width, height): (u32, u32), handles: &[(f64, f64)]) -> Self {
        let mut scene = Self::new(width, height, vec![u8::MAX; width as usize * height as usize * 4], handles);
        scene.project.domain = Some(DomainSpec::Image);
        scene
    }

    fn new(width: u32, height: u32, rgba: Vec<u8>, handles: &[(f64, f64)]) -> Self {
        let mut project = Project::new(ImageRef::new("drawn.png", width, height));
        project.handles = handles.iter().enumerate().map(|(id, &rest)| handle(id, rest.into())).collect();
        Self { project, rgba }
    }

    /// The same scene with straight bars besides.
    fn with_bars(mut self, bars: &[[(f64, f64); 2]]) -> Self {
        let bar = |(at, ends): (usize, &[(f64, f64); 2])| Handle::bar(format!("b{at}"), *ends).turned(Rotation::Auto);
        self.project.handles.extend(bars.iter().enumerate().map(bar));
        self
    }

    /// The same picture with other numbers of samples and, at least, of virtual sites.
    #[must_use]
    pub fn project(&self, samples: u32, virtual_sites: u32) -> Project {
        let mut project = self.project.clone();
        project.samples = samples;
        project.pose.density = virtual_sites;
        project
    }

    /// The picture.
    ///
    /// # Errors
    /// None that a scene of this module has.
    pub fn picture(&self) -> Result<Picture<'_>, Error> {
        Picture::new(self.project.image.width, self.project.image.height, &self.rgba)
    }
}

/// A point handle that stays where it is.
#[must_use]
pub fn handle(id: usize, rest: DVec2) -> Handle {
    Handle::point(format!("h{id}"), rest)
}

/// The scenes of Table I, in its order.
#[must_use]
pub fn table_1() -> [Scene; 6] {
    [tower(), wolf(), portrait(), alligator(), rabbit(), road()]
}

/// A tapering tower with storeys, battlements and a gate; bars up both sides.
fn tower() -> Scene {
    let mut limbs =
        vec![limb((250.0, 730.0), 130.0, (250.0, 200.0), 70.0), limb((90.0, 760.0), 30.0, (410.0, 760.0), 30.0)];
    limbs.extend([180.0, 380.0, 560.0].map(|y| limb((165.0 - y / 10.0, y), 14.0, (335.0 + y / 10.0, y), 14.0)));
    limbs.extend(
        [0, 1, 2, 3]
            .map(|i| limb((175.0 + 50.0 * f64::from(i), 110.0), 10.0, (175.0 + 50.0 * f64::from(i), 170.0), 12.0)),
    );
    let gate =
        [limb((250.0, 830.0), 36.0, (250.0, 690.0), 36.0), spot((250.0, 290.0), 16.0), spot((250.0, 470.0), 18.0)];
    let storeys = [230.0, 320.0, 410.0, 500.0, 590.0, 700.0];
    let side = |x: f64, y: f64, lean: f64| [(x - lean * (y - 30.0), y - 30.0), (x - lean * (y + 30.0), y + 30.0)];
    let bars: Vec<_> =
        storeys.iter().flat_map(|&y| [side(196.0, y, 1.0 / 16.0), side(304.0, y, -1.0 / 16.0)]).collect();
    Scene::on_limbs((500, 820), &limbs, &gate, &[]).with_bars(&bars)
}

/// A four-legged animal from the side; bars along its legs, points on snout and tail.
fn wolf() -> Scene {
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
    Scene::on_limbs((700, 500), &limbs, &[], &[(90.0, 150.0), (640.0, 302.0)]).with_bars(&bars)
}

/// A whole picture; bars along brows, eyes, mouth and shoulders.
fn portrait() -> Scene {
    let bars = [
        [(205.0, 260.0), (265.0, 252.0)],
        [(335.0, 252.0), (395.0, 260.0)],
        [(215.0, 300.0), (260.0, 300.0)],
        [(340.0, 300.0), (385.0, 300.0)],
        [(250.0, 430.0), (350.0, 430.0)],
        [(80.0, 690.0), (200.0, 620.0)],
        [(400.0, 620.0), (520.0, 690.0)],
    ];
    Scene::on_rectangle((600, 780), &[]).with_bars(&bars)
}

/// A long, low animal; handles on snout, back and tail.
fn alligator() -> Scene {
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
    Scene::on_limbs((900, 360), &limbs, &[], &[(60.0, 155.0), (430.0, 180.0), (840.0, 182.0)])
}

/// A sitting animal with long ears; handles on ears, belly and paws.
fn rabbit() -> Scene {
    let limbs = [
        limb((300.0, 520.0), 150.0, (300.0, 420.0), 115.0),
        spot((300.0, 290.0), 98.0),
        limb((260.0, 220.0), 34.0, (215.0, 50.0), 24.0),
        limb((340.0, 220.0), 34.0, (385.0, 50.0), 24.0),
        limb((230.0, 620.0), 60.0, (160.0, 670.0), 38.0),
        limb((370.0, 620.0), 60.0, (440.0, 670.0), 38.0),
        spot((435.0, 480.0), 44.0),
    ];
    Scene::on_limbs((600, 740), &limbs, &[], &[(217.0, 60.0), (383.0, 60.0), (300.0, 470.0), (170.0, 668.0)])
}

/// A whole picture; bars along both kerbs and the middle of a road that narrows into the distance, points beside it.
fn road() -> Scene {
    let bars = [[(120.0, 560.0), (390.0, 240.0)], [(680.0, 560.0), (430.0, 240.0)], [(400.0, 560.0), (408.0, 300.0)]];
    Scene::on_rectangle((800, 600), &[(120.0, 200.0), (410.0, 120.0), (690.0, 200.0)]).with_bars(&bars)
}

/// The figure of Table II; handles on head, hands, belly and feet, which need no virtual site.
#[must_use]
pub fn gingerbread() -> Scene {
    let limbs = [
        spot((500.0, 190.0), 150.0),
        limb((500.0, 400.0), 120.0, (500.0, 600.0), 150.0),
        limb((460.0, 420.0), 85.0, (180.0, 430.0), 75.0),
        limb((540.0, 420.0), 85.0, (820.0, 430.0), 75.0),
        limb((440.0, 640.0), 95.0, (330.0, 870.0), 88.0),
        limb((560.0, 640.0), 95.0, (670.0, 870.0), 88.0),
    ];
    let handles = [(500.0, 190.0), (180.0, 430.0), (820.0, 430.0), (500.0, 500.0), (330.0, 870.0), (670.0, 870.0)];
    Scene::on_limbs((1000, 1000), &limbs, &[], &handles)
}

/// One more handle on the gingerbread figure: a knee.
#[must_use]
pub fn one_more() -> Handle {
    handle(6, DVec2::new(615.0, 750.0))
}

/// Raises the figure's left hand.
pub fn raised(handles: &mut [Handle]) {
    if let Some(Shape::Point { posed, .. }) = handles.get_mut(1).map(|handle| &mut handle.shape) {
        *posed = DVec2::new(230.0, 210.0);
    }
}

/// Points spread evenly over a picture, by Roberts's R₂ sequence: multiples of the plastic number's powers.
pub fn spread(size: DVec2) -> impl Iterator<Item = DVec2> {
    let at = |i: u32| DVec2::new(0.754_877_666_246_692_7, 0.569_840_290_998_053_2) * f64::from(i);
    (1..).map(move |i| at(i).fract() * size)
}
