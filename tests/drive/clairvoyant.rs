//! The best drive in advance, against brute force on small maps.

use formicarium::drive::clairvoyant;
use formicarium::exact::Reference;
use formicarium::map::{Cell, offset};
use formicarium::scenario::Scenario;

use super::moving::{map_at, random};

/// The least length to the goal within so many steps: from step to step, to every cell from every other one, without an order or an end.
fn brute_force(scenario: &Scenario, most: u32) -> f64 {
    let cells = scenario.grid.len();
    let mut length = vec![f64::INFINITY; cells];
    length[scenario.start as usize] = 0.0;
    for step in 0..most {
        let mut after = length.clone();
        for cell in (0..cells as Cell).filter(|&c| length[c as usize].is_finite()) {
            let at = scenario.grid.point(cell);
            let map = map_at(scenario, step, at);
            let (x, y) = (i64::from(at.x), i64::from(at.y));
            for d in (0..16).filter(|&d| scenario.spec.movement.allows(&map, x, y, d)) {
                let (dx, dy) = offset(d);
                let to = cell.wrapping_add_signed(dy * scenario.grid.width() as i32 + dx) as usize;
                after[to] = after[to].min(length[cell as usize] + f64::from(dx * dx + dy * dy).sqrt());
            }
        }
        length = after;
    }
    length[scenario.goal as usize]
}

#[test]
fn the_best_drive_in_advance_is_that_of_brute_force() {
    let (mut proven, mut longer) = (0, 0);
    for seed in 0..400 {
        let scenario = random(3 + seed % 3, 9000 + seed);
        let best = brute_force(&scenario, 150);
        match clairvoyant(&scenario) {
            Reference::Proven { value } => {
                assert!((value - best).abs() < 1e-9, "seed {seed}: {value}, not {best}");
                proven += 1;
                let still = formicarium::exact::optimum(&scenario);
                longer += u32::from(still.is_none_or(|still| value > still + 1e-9));
            }
            found => assert!(found == Reference::NoPath && best == f64::INFINITY, "seed {seed}: {found:?}, not {best}"),
        }
    }
    assert!(proven > 300 && longer > 20, "{proven} drives, {longer} of them longer than the path on the map as it was");
}
