//! Every planner with values at and beyond the ends of their ranges, on small maps of every ground, some of them with quantities that no
//! real map has: it refuses by name, or runs; and a snapshot of it ends as the unbroken run.

use std::iter::repeat_n;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use formicarium::catalog::{self, CATALOG};
use formicarium::error::Error;
use formicarium::map::{CornerRule, Grid, Measure, Movement, Moves, Point, SliceRules};
use formicarium::metrics::Metrics;
use formicarium::params::{ParamKind, ParamSpec, Value, Values};
use formicarium::path::{PathKind, audit, audit_slices, points};
use formicarium::planner::{Granularity, Ground, Layer, Planner, PlannerEntry};
use formicarium::scenario::{EnergyRule, Goal, Scenario, ScenarioSpec, SmoothingRule, TerrainMoves, TerrainSpec, Vehicle};

use crate::limits::Limits;
use crate::random::Random;
use crate::readers::told;
use crate::watch::{Fault, watch};

/// Planners that ran.
pub static RAN: AtomicU64 = AtomicU64::new(0);

/// What an input of this kind consists of, for people.
pub struct Case {
    scenario: Arc<Scenario>,
    entry: &'static PlannerEntry,
    values: Values,
    seed: u32,
    before: (usize, usize),
}

/// A case; none where the map that came out cannot be used, which must be said by name.
pub fn case(random: &mut Random) -> Result<Option<Case>, Fault> {
    let Some(scenario) = scenario(random)? else { return Ok(None) };
    let ground = Ground::of(&scenario);
    let able: Vec<&PlannerEntry> =
        CATALOG.iter().copied().filter(|e| e.grounds.contains(&ground) && e.max_goals as usize >= scenario.goals.len()).collect();
    // Now and then one that does not know this ground.
    let any = able.is_empty() || random.one_in(30);
    let entry = *random.of_list(if any { CATALOG } else { &able });
    let values = values(random, entry);
    let before = (random.below(3), random.below(9));
    Ok(Some(Case { scenario, entry, values, seed: random.word(), before }))
}

impl Case {
    pub fn check(&self) -> Result<(), Fault> {
        watch(self.entry.id, Limits::planner, || self.run())
    }

    /// To make it again by hand.
    pub fn words(&self) -> String {
        let Self { scenario, entry, values, seed, .. } = self;
        let map = formicarium::formats::export(&scenario.grid, &scenario.spec, formicarium::formats::Export::Scenario);
        let set: Vec<String> = values.iter().map(|(key, value)| format!("--set {key}={value}")).collect();
        format!("formicarium plan map.json --planner {} --seed {seed} {}\n\nmap.json:\n{map}", entry.id, set.join(" "))
    }

    fn build(&self) -> Result<Option<Box<dyn Planner>>, Fault> {
        match catalog::build(&self.scenario, self.entry.id, None, &self.values, self.seed) {
            Ok(planner) => Ok(Some(planner)),
            Err(error) => told(&Error::from(error).report()).map(|()| None),
        }
    }

    fn run(&self) -> Result<(), Fault> {
        let Some(mut original) = self.build()? else { return Ok(()) };
        RAN.fetch_add(1, Ordering::Relaxed);
        let (iterations, moves) = self.before;
        let steps = repeat_n(Granularity::Iteration, iterations).chain(repeat_n(Granularity::Move, moves));
        steps.for_each(|by| _ = original.advance(by));
        let mut snapshot = original.snapshot();
        look_at(&*original, &self.scenario);
        [&mut original, &mut snapshot].into_iter().for_each(finish);
        same(&*original, &*snapshot, "a snapshot ends as its original")?;
        if let Some(mut unbroken) = self.build()? {
            finish(&mut unbroken);
            if unbroken.status().is_finished() && original.status().is_finished() {
                same(&*original, &*unbroken, "a run by moves ends as one by iterations")?;
            }
        }
        look_at(&*original, &self.scenario);
        self.sound(&*original)
    }

    /// The path that came out is one, and can be measured.
    fn sound(&self, planner: &dyn Planner) -> Result<(), Fault> {
        let Some(best) = planner.best() else { return Ok(()) };
        let scenario = &*self.scenario;
        let flaw = match &scenario.slices {
            Some(slices) => audit_slices(scenario, &slices.points(&best.path)).err(),
            None => audit(scenario, &points(scenario, &best.path), planner.objective().path_kind()).err(),
        };
        let refined = best.refined.as_ref().filter(|_| scenario.slices.is_none());
        let bent = refined.and_then(|refined| audit(scenario, &points(scenario, &refined.path), PathKind::Polyline).err());
        if let Some(flaw) = flaw.or(bent) {
            return Err(Fault::broken(&format!("{}: its path is one", self.entry.id), flaw.to_string()));
        }
        let path = best.result().0;
        let metrics = Metrics::of(scenario, path);
        let _ = planner.value(&metrics);
        Ok(())
    }
}

/// A few iterations; to the end where that is near.
fn finish(planner: &mut Box<dyn Planner>) {
    for _ in 0..12 {
        if planner.advance(Granularity::Iteration).is_finished() {
            return;
        }
    }
}

fn same(a: &dyn Planner, b: &dyn Planner, promise: &str) -> Result<(), Fault> {
    let stands = |p: &dyn Planner| (p.digest().hex(), p.status(), p.effort());
    if stands(a) == stands(b) {
        return Ok(());
    }
    Err(Fault::broken(promise, format!("{:?} and {:?}", stands(a), stands(b))))
}

/// What a page asks for while it runs.
fn look_at(planner: &dyn Planner, scenario: &Scenario) {
    let mut layer = Vec::new();
    for kind in [Layer::Trail, Layer::Visits, Layer::Heuristic, Layer::Cost, Layer::Priority] {
        planner.layer(kind, &mut layer);
    }
    let mut ants = Vec::new();
    planner.ants(&mut ants);
    let places = scenario.slices.as_ref().map_or(scenario.grid.len(), |slices| slices.places()) as u32;
    for place in [0, scenario.start, scenario.goal, places / 2, places, u32::MAX] {
        planner.moves_from(place);
    }
    let _ = (planner.bytes(), planner.budget(), planner.colony_size());
}

fn values(random: &mut Random, entry: &PlannerEntry) -> Values {
    let specs = (entry.specs)();
    let mut values = match entry.presets {
        [] => Values::new(),
        presets if random.one_in(2) => random.of_list(presets).values(),
        _ => Values::new(),
    };
    let often = 1 + random.below(8);
    for spec in &specs {
        if random.one_in(often) {
            values.insert(spec.key.into(), value(random, spec));
        }
    }
    // So that runs come to an end, mostly; many ants only now and then.
    let usual = [
        ("iterations", 6, 9),
        ("seed_iterations", 4, 9),
        ("ants", 12, 4),
        ("particles", 12, 4),
        ("fireworks", 6, 4),
        ("order_iterations", 20, 9),
        ("order_limit", 400, 9),
    ];
    for (key, most, often) in usual {
        if specs.iter().any(|spec| spec.key == key) && !random.one_in(often * 4) {
            values.insert(key.into(), Value::Number(f64::from(random.between(1, most))));
        }
    }
    values
}

/// Mostly within the range or at its ends, otherwise anything.
fn value(random: &mut Random, spec: &ParamSpec) -> Value {
    const ODD: [f64; 12] = [
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        0.0,
        -0.0,
        -1.0,
        1e308,
        5e-324,
        4_294_967_295.0,
        4_294_967_296.0,
        0.5,
        1e-300,
    ];
    if random.one_in(150) {
        return [Value::Flag(random.one_in(2)), Value::Text("x".into()), Value::Number(*random.of_list(&ODD))][random.below(3)]
            .clone();
    }
    match &spec.kind {
        ParamKind::Flag => Value::Flag(random.one_in(2)),
        ParamKind::Choice { options } => Value::from(random.of_list(options).id),
        ParamKind::Integer { min, max } | ParamKind::Real { min, max } => {
            let whole = matches!(spec.kind, ParamKind::Integer { .. });
            let inside = min + (max - min) * random.unit();
            // Close to the lower end, on a scale of powers.
            let small = min + (max - min) * libm::exp2(-60.0 * random.unit());
            let number = match random.below(100) {
                0 => min - 1.0,
                1 => max * 1.000_001 + f64::from(u8::from(whole)),
                2..=20 => *min,
                21..=40 => *max,
                41..=60 => small,
                _ => inside,
            };
            Value::Number(if whole { number.floor() } else { number })
        }
    }
}

/// Quantities as they are, and as nobody has them.
fn quantity(random: &mut Random) -> f64 {
    const WILD: [f64; 12] = [5e-324, 1e-300, 1e-30, 1e-9, 0.05, 30.0, 1e6, 1e9, 1e30, 1e300, 1.7e308, 0.0];
    if random.one_in(25) { *random.of_list(&WILD) } else { 0.5 + random.unit() }
}

fn height(random: &mut Random, span: f64) -> f32 {
    const WILD: [f32; 7] = [f32::NAN, f32::MAX, f32::MIN, 1e30, -9999.0, 1e-40, -0.0];
    if random.one_in(400) { *random.of_list(&WILD) } else { (span * random.unit()) as f32 }
}

pub fn scenario(random: &mut Random) -> Result<Option<Arc<Scenario>>, Fault> {
    let long = if random.one_in(5) { 24 } else { 9 };
    let (width, height) = (random.between(1, long), random.between(1, long));
    let density = 0.5 * random.unit() * random.unit();
    let cells: Vec<u8> = (0..width * height).map(|_| u8::from(random.unit() < density)).collect();
    let grid = Grid::from_bytes(width, height, &cells).expect("a rectangle");
    let terrain = if random.one_in(2) { Some(terrain(random)) } else { None };
    let grid = match terrain {
        Some(_) => match grid.with_heights(heights(random, width * height)) {
            Ok(grid) => grid,
            Err(error) => return told(&Error::from(error).report()).map(|()| None),
        },
        None => grid,
    };
    let free: Vec<Point> = (0..grid.len() as u32).filter(|&cell| !grid.is_blocked(cell)).map(|cell| grid.point(cell)).collect();
    if free.is_empty() {
        return Ok(None);
    }
    let spec = spec(random, &grid, terrain, &free);
    match Scenario::new(grid, spec) {
        Ok(scenario) => Ok(Some(Arc::new(scenario))),
        Err(error) => told(&Error::from(error).report()).map(|()| None),
    }
}

fn heights(random: &mut Random, count: u32) -> Vec<f32> {
    let span = quantity(random) * 20.0;
    (0..count).map(|_| height(random, span)).collect()
}

fn spec(random: &mut Random, grid: &Grid, terrain: Option<TerrainSpec>, free: &[Point]) -> ScenarioSpec {
    let moves = *random.of_list(if terrain.is_some() {
        &[Moves::Eight, Moves::Sixteen, Moves::Four]
    } else {
        &[Moves::Eight, Moves::Four, Moves::Eight]
    });
    let count = if terrain.is_none() && random.one_in(3) { 1 + random.below(4) } else { 1 };
    let goal = |random: &mut Random| {
        let [area, strength, danger] = [(); 3].map(|()| quantity(random));
        Goal { at: *random.of_list(free), name: String::new(), area, strength, danger }
    };
    let slices = terrain.is_some_and(|terrain| matches!(terrain.moves, TerrainMoves::Slices(_)));
    // By slices one goes from the first column to the last.
    let end = |x: u32, random: &mut Random| {
        let there: Vec<Point> = free.iter().copied().filter(|p| p.x == x).collect();
        if there.is_empty() { *random.of_list(free) } else { *random.of_list(&there) }
    };
    let mut goals: Vec<Goal> = (0..count).map(|_| goal(random)).collect();
    let mut start = *random.of_list(free);
    if slices {
        start = end(0, random);
        goals[0].at = end(grid.width() - 1, random);
    }
    ScenarioSpec {
        resolution: quantity(random),
        movement: Movement { moves, corner_rule: *random.of_list(&CornerRule::ALL) },
        goals,
        vehicle: vehicle(random),
        terrain,
        ..ScenarioSpec::new(grid, start, Point::new(0, 0))
    }
}

fn vehicle(random: &mut Random) -> Vehicle {
    Vehicle {
        speed: quantity(random),
        seconds_per_turn: quantity(random),
        energy: random.one_in(4).then(|| EnergyRule { per_radian: quantity(random), ..EnergyRule::default() }),
        smoothing: random.one_in(4).then(|| SmoothingRule { max_curvature: quantity(random) }),
    }
}

fn terrain(random: &mut Random) -> TerrainSpec {
    let moves = if random.one_in(2) {
        TerrainMoves::Surface { max_slope: if random.one_in(2) { 90.0 } else { random.unit() * 91.0 } }
    } else {
        let levels = if random.one_in(8) { random.between(0, 256) } else { random.between(4, 24) };
        TerrainMoves::Slices(SliceRules {
            // Often so high that nothing is in the way.
            level: quantity(random) * *random.of_list(&[1.0, 4.0, 20.0]),
            levels,
            max_aside: random.between(0, 5),
            max_climb: random.between(0, 5),
            start_level: random.between(1, levels.max(1)),
            goal_level: random.between(1, levels.max(1)),
            measure: *random.of_list(&[Measure::Cost, Measure::Length]),
        })
    };
    TerrainSpec { vertical_unit: quantity(random), moves }
}
