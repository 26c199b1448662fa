//! The motions of a clip: integers at some of its frames, interpolated linearly.

use super::{
    bytes::{Reader, Writer},
    error::RigError,
    order::Order,
    steps::{round, value},
};
use crate::{
    pose::{Motion, Strain},
    project::Looping,
};

/// The finest steps of any number.
const MOST_BITS: u8 = 24;
/// Maximum number of frames of a clip, so that no reader runs out of memory.
const MOST_FRAMES: u32 = 1 << 16;
/// Numbers of a motion: angle, three of the strain, and two of the translation.
const NUMBERS: usize = 6;

/// A clip of a rig.
#[derive(Debug, Clone, PartialEq)]
pub struct RigClip {
    /// The name in the project. It is empty for the pose of the handles, in a rig of a project without clips.
    pub name: String,
    /// Duration in seconds. 0 for a pose.
    pub duration: f64,
    /// Whether and how it continues after the end.
    pub looping: Looping,
    /// The last frame is at the end of the clip, the first one is frame 0.
    pub last_frame: u32,
    pub(super) bits: MotionBits,
    /// Frames with motions, ascending. The first is 0, and the last is the last frame.
    pub(super) keys: Vec<u32>,
    /// Keys × sites.
    pub(super) motions: Vec<[i32; NUMBERS]>,
    /// Ascending by frame, the first at frame 0.
    pub(super) orders: Vec<Order>,
}

/// Numbers of motions are multiples of 2 to the power of minus these.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct MotionBits {
    /// For angles in radians.
    pub(super) angle: u8,
    /// Of strains.
    pub(super) strain: u8,
    /// For translations in pixels.
    pub(super) place: u8,
}

impl MotionBits {
    fn of(self, number: usize) -> u8 {
        [self.angle, self.strain, self.strain, self.strain, self.place, self.place][number]
    }

    /// `None` if a number is too large.
    pub(super) fn rounded(self, motion: &Motion) -> Option<[i32; NUMBERS]> {
        let Motion { angle, strain, translation, .. } = *motion;
        let exact = [angle, strain.xx, strain.xy, strain.yy, translation.x, translation.y];
        let mut steps = [0; NUMBERS];
        for (number, step) in steps.iter_mut().enumerate() {
            *step = round(exact[number], self.of(number))?;
        }
        Some(steps)
    }

    /// The motion between two motions, from 0 at the first to 1 at the second.
    pub(super) fn between(self, [a, b]: [&[i32; NUMBERS]; 2], along: f64) -> Motion {
        let number = |at: usize| {
            let [a, b] = [a, b].map(|steps| value(steps[at], self.of(at)));
            a + along * (b - a)
        };
        Motion {
            angle: number(0),
            strain: Strain { xx: number(1), xy: number(2), yy: number(3) },
            translation: [number(4), number(5)].into(),
            depth: 0.0,
        }
    }
}

impl RigClip {
    /// The number of frames with stored motions.
    #[must_use]
    pub fn keys(&self) -> usize {
        self.keys.len()
    }

    /// The motions at a frame, from 0 to the last one.
    pub(super) fn motions_at(&self, frame: f64, sites: usize) -> Vec<Motion> {
        let after = self.keys.partition_point(|&key| f64::from(key) <= frame).clamp(1, self.keys.len());
        let before = after - 1;
        let after = after.min(self.keys.len() - 1);
        let [start, end] = [before, after].map(|key| f64::from(self.keys[key]));
        let along = if end > start { (frame - start) / (end - start) } else { 0.0 };
        let of = |key: usize| &self.motions[key * sites..(key + 1) * sites];
        let pairs = of(before).iter().zip(of(after));
        pairs.map(|(a, b)| self.bits.between([a, b], along)).collect()
    }

    /// The drawing order at a frame.
    pub(super) fn order_at(&self, frame: f64) -> &Order {
        let after = self.orders.partition_point(|order| f64::from(order.frame) <= frame);
        &self.orders[after.max(1) - 1]
    }

    pub(super) fn write(&self, to: &mut Writer, sites: usize) {
        to.text(&self.name);
        to.number(self.duration);
        to.byte(match self.looping {
            Looping::None => 0,
            Looping::Repeat => 1,
            Looping::Alternate => 2,
        });
        to.varint(self.last_frame);
        to.count(self.keys.len());
        self.keys.windows(2).for_each(|pair| to.varint(pair[1] - pair[0]));
        [self.bits.angle, self.bits.strain, self.bits.place].iter().for_each(|&bits| to.byte(bits));
        for number in 0..NUMBERS {
            for site in 0..sites {
                let mut before = 0_i32;
                for motion in self.motions.iter().skip(site).step_by(sites) {
                    to.signed(motion[number].wrapping_sub(before));
                    before = motion[number];
                }
            }
        }
        to.count(self.orders.len());
        let mut before: Option<&Order> = None;
        for order in &self.orders {
            to.varint(order.frame - before.map_or(0, |before| before.frame));
            order.write(before, to);
            before = Some(order);
        }
    }

    pub(super) fn read(from: &mut Reader<'_>, sites: usize, triangles: usize) -> Result<Self, RigError> {
        let name = from.text()?;
        let duration = from.number()?;
        let looping = match from.byte()? {
            0 => Looping::None,
            1 => Looping::Repeat,
            2 => Looping::Alternate,
            _ => return Err(from.wrong("has an unknown loop mode")),
        };
        let last_frame = from.varint()?;
        from.expect(last_frame <= MOST_FRAMES, "has too many frames")?;
        let is_still = last_frame == 0;
        let has_time = if is_still { duration == 0.0 } else { duration > 0.0 && duration.is_finite() };
        from.expect(has_time, "has a duration that does not match its frames")?;
        let count = from.count(1)?;
        from.expect(count >= 1, "has no motions")?;
        let mut keys = vec![0_u32];
        for _ in 1..count {
            let step = from.varint()?;
            let key = keys[keys.len() - 1].saturating_add(step);
            from.expect(step > 0 && key <= last_frame, "has keys out of order")?;
            keys.push(key);
        }
        from.expect(keys.last() == Some(&last_frame), "has no motions at its end")?;
        let bits = MotionBits { angle: from.byte()?, strain: from.byte()?, place: from.byte()? };
        let are_coarse = [bits.angle, bits.strain, bits.place].iter().all(|&bits| bits <= MOST_BITS);
        from.expect(are_coarse, "stores motions with too many bits")?;
        from.expect(from.has(count.checked_mul(sites).and_then(|n| n.checked_mul(NUMBERS))), "ends too early")?;
        let mut motions = vec![[0; NUMBERS]; count * sites];
        for number in 0..NUMBERS {
            for site in 0..sites {
                let mut before = 0_i32;
                for motion in motions.iter_mut().skip(site).step_by(sites) {
                    before = before.wrapping_add(from.signed()?);
                    motion[number] = before;
                }
            }
        }
        let mut orders: Vec<Order> = Vec::new();
        for _ in 0..from.count(2)? {
            let step = from.varint()?;
            let is_next = orders.last().map_or(step == 0, |_| step > 0);
            let frame = orders.last().map_or(0, |order| order.frame).saturating_add(step);
            from.expect(is_next && frame <= last_frame, "has unsorted drawing orders")?;
            let order = Order::read(from, frame, orders.last(), triangles)?;
            orders.push(order);
        }
        from.expect(!orders.is_empty(), "has no drawing order")?;
        Ok(Self { name, duration, looping, last_frame, bits, keys, motions, orders })
    }
}
