//! Round hills: a sum of Gaussian bells at random places. The rougher the ground, the narrower the hills and the more of them, so that they
//! cover the map as often.

use super::terrain::Field;
use super::{Dice, RESOLUTION};

/// Difference of height over the longer side of the map.
const RELIEF: f64 = 0.12;

/// Hills at roughness 0.
const FEWEST: f64 = 6.0;

/// Radius σ of the widest hills at roughness 0, over the longer side of the map; the narrowest have half of it.
const WIDEST: f64 = 0.25;

/// A bell ends at this many radii: what lies beyond is less than 1/250,000 of it.
const REACH: f64 = 5.0;

/// Heights in metres, from 0 upwards.
pub(super) fn ground(width: u32, height: u32, dice: &mut Dice, roughness: f64) -> Field {
    let mut field = Field::flat(width, height);
    let longer = f64::from(width.max(height));
    let narrower = 1.0 - roughness;
    for _ in 0..libm::ceil(FEWEST / (narrower * narrower)) as u32 {
        let (x, y) = (f64::from(width) * dice.share(), f64::from(height) * dice.share());
        let radius = WIDEST * longer * narrower * (0.5 + 0.5 * dice.share());
        hill(&mut field, (x, y), radius.max(0.5));
    }
    field.stretched(RELIEF * longer * RESOLUTION)
}

/// Adds radius · exp(−d² / 2σ²): a hill is as high as it is wide. The bell is the product of one along x and one along y.
fn hill(field: &mut Field, (x, y): (f64, f64), radius: f64) {
    let bell = |at: f64| libm::exp(-at * at / (2.0 * radius * radius));
    let reach = |at: f64, side: u32| {
        let end = |at: f64| libm::ceil(at.clamp(0.0, f64::from(side))) as usize;
        end(at - REACH * radius)..end(at + REACH * radius)
    };
    let columns = reach(x, field.width);
    let along_x: Vec<f64> = columns.clone().map(|i| radius * bell(i as f64 - x)).collect();
    for j in reach(y, field.height) {
        let along_y = bell(j as f64 - y);
        let row = &mut field.heights[j * field.width as usize..][columns.clone()];
        row.iter_mut().zip(&along_x).for_each(|(height, along_x)| *height += along_x * along_y);
    }
}
