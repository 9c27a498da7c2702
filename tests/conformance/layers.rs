//! What a planner shows of its inside.

use formicarium::planner::{Granularity, Layer, Planner};

use super::{everywhere, planner};

/// A layer's values, bit by bit, with its version.
fn shown(planner: &dyn Planner, kind: Layer) -> (Option<u64>, Vec<u32>) {
    let mut field = Vec::new();
    assert!(planner.layer(kind, &mut field), "it is listed");
    (planner.layer_version(kind), field.iter().map(|value| value.to_bits()).collect())
}

#[test]
fn a_layer_stays_as_long_as_its_version_does() {
    everywhere(|entry, what, scenario| {
        let mut planner = planner(entry, scenario, 3);
        let mut before: Vec<_> = entry.layers.iter().map(|&kind| shown(&*planner, kind)).collect();
        // Some iterations move by move, then whole ones.
        let steps = std::iter::repeat_n(Granularity::Move, 60).chain(std::iter::repeat(Granularity::Iteration));
        for by in steps {
            let ended = planner.advance(by).is_finished();
            for (&kind, before) in entry.layers.iter().zip(&mut before) {
                let now = shown(&*planner, kind);
                if now.0.is_some() && now.0 == before.0 {
                    assert_eq!(now.1, before.1, "{what}: {kind:?} has changed, its version {:?} has not", now.0);
                }
                assert!(now.0.is_none() || now.0 >= before.0, "{what}: the version of {kind:?} gets smaller");
                *before = now;
            }
            if ended {
                break;
            }
        }
    });
}

/// What is drawn of the map and of a colony's beginning need not be drawn again.
#[test]
fn what_ants_see_is_computed_once() {
    everywhere(|entry, what, scenario| {
        let fades = ["ship", "terrain-epf", "custom"].contains(&entry.id);
        if fades
            || entry.layers.contains(&Layer::SeedPath)
            || !entry.layers.contains(&Layer::Heuristic)
            || scenario.goals.len() > 1
        {
            return;
        }
        let mut planner = planner(entry, scenario, 3);
        planner.advance(Granularity::Move);
        let first = planner.layer_version(Layer::Heuristic);
        assert!(first.is_some(), "{what}");
        planner.run();
        assert_eq!(planner.layer_version(Layer::Heuristic), first, "{what}");
    });
}
