//! The point robot against a search over all corners, each tried against each.

use std::cmp::Ordering;

use super::*;
use crate::exact::geodesic::Field;
use crate::map::{Cell, CornerRule, Generator, Grid, Movement, Moves, Point, generate};

/// A place in half cells: corners have even coordinates, centres odd ones.
type Place = (i32, i32);

/// The obstacles, and where a shortest way may bend.
struct Plane<'a> {
    grid: &'a Grid,
    /// Whether the point squeezes between two obstacles that touch at a corner.
    squeezes: bool,
    /// The goal, the start, then the corners.
    places: Vec<Place>,
}

impl<'a> Plane<'a> {
    fn of(scenario: &'a Scenario) -> Self {
        let (grid, movement) = (&scenario.grid, scenario.spec.movement);
        let squeezes = movement.moves != Moves::Four && movement.corner_rule == CornerRule::Always;
        let mut plane = Self { grid, squeezes, places: [scenario.goal, scenario.start].map(|c| centre(grid.point(c))).into() };
        for y in 0..=grid.height() as i32 {
            let corners = (0..=grid.width() as i32).filter(|&x| plane.bends_at(x, y));
            let corners: Vec<Place> = corners.map(|x| (2 * x, 2 * y)).collect();
            plane.places.extend(corners);
        }
        plane
    }

    fn free(&self, x: i32, y: i32) -> bool {
        self.grid.is_free_at(i64::from(x), i64::from(y))
    }

    /// Whether a shortest way may bend at the upper left corner of the cell (x, y): one obstacle there, or two that touch.
    fn bends_at(&self, x: i32, y: i32) -> bool {
        let around = [self.free(x - 1, y - 1), self.free(x, y - 1), self.free(x - 1, y), self.free(x, y)];
        let touching = around == [true, false, false, true] || around == [false, true, true, false];
        around.iter().filter(|&&free| !free).count() == 1 || (self.squeezes && touching)
    }

    /// Whether the straight way between two different places is free.
    fn sees(&self, from: Place, to: Place) -> bool {
        match (to.0 - from.0, to.1 - from.1) {
            (0, dy) if from.0 % 2 == 0 => self.along(dy / 2, |k, side| {
                let y = if dy > 0 { from.1 / 2 + k } else { from.1 / 2 - k - 1 };
                self.free(from.0 / 2 - side, y)
            }),
            (dx, 0) if from.1 % 2 == 0 => self.along(dx / 2, |k, side| {
                let x = if dx > 0 { from.0 / 2 + k } else { from.0 / 2 - k - 1 };
                self.free(x, from.1 / 2 - side)
            }),
            (dx, dy) => self.across(from, (dx, dy)),
        }
    }

    /// Along an edge line of the map: at every cell's length one of the two sides must be free, and where the side changes the point
    /// must squeeze through a corner. `free(k, side)` is the k-th cell on a side.
    fn along(&self, cells: i32, free: impl Fn(i32, i32) -> bool) -> bool {
        let mut before = [true; 2];
        (0..cells.abs()).all(|k| {
            let now = [free(k, 0), free(k, 1)];
            let stays = (now[0] && before[0]) || (now[1] && before[1]);
            before = now;
            stays || (self.squeezes && (now[0] || now[1]))
        })
    }

    /// Across the cells.
    fn across(&self, from: Place, (dx, dy): (i32, i32)) -> bool {
        let (sx, sy, nx, ny) = (dx.signum(), dy.signum(), dx.abs(), dy.abs());
        let (mut x, mut y) = (first_cell(from.0, sx), first_cell(from.1, sy));
        // When the way leaves its cell by a side in x and in y, on the scale on which it ends at nx·ny; never where it runs in parallel.
        let side = |at: i32, cell: i32, sign: i32| if sign > 0 { 2 * cell + 2 - at } else { at - 2 * cell };
        let end = nx.max(1) * ny.max(1);
        let mut leaves_x = if sx == 0 { i32::MAX } else { side(from.0, x, sx) * ny.max(1) };
        let mut leaves_y = if sy == 0 { i32::MAX } else { side(from.1, y, sy) * nx.max(1) };
        let mut free = self.free(x, y);
        while free && leaves_x.min(leaves_y) < end {
            let order = leaves_x.cmp(&leaves_y);
            if order.is_eq() {
                free = self.squeezes || self.free(x + sx, y) || self.free(x, y + sy);
            }
            if order.is_le() {
                (x, leaves_x) = (x + sx, leaves_x + 2 * ny.max(1));
            }
            if order.is_ge() {
                (y, leaves_y) = (y + sy, leaves_y + 2 * nx.max(1));
            }
            free = free && self.free(x, y);
        }
        free
    }

    /// A* over all places, by the straight distance to the goal.
    fn shortest(&self) -> Option<f64> {
        let [goal, start] = [0, 1];
        let mut g = vec![f64::INFINITY; self.places.len()];
        let mut open: Vec<usize> = (0..self.places.len()).collect();
        g[start] = 0.0;
        if self.places[start] == self.places[goal] {
            return Some(0.0);
        }
        let to_goal = |k: usize| distance(self.places[k], self.places[goal]);
        loop {
            let f = |k: usize| g[k] + to_goal(k);
            let next = open.iter().enumerate().min_by(|a, b| f(*a.1).total_cmp(&f(*b.1)).then(Ordering::Less));
            let (index, &here) = next.filter(|(_, k)| g[**k].is_finite())?;
            if here == goal {
                return Some(g[goal]);
            }
            open.swap_remove(index);
            for &k in &open {
                let way = g[here] + distance(self.places[here], self.places[k]);
                if way < g[k] && way + to_goal(k) < g[goal] && self.sees(self.places[here], self.places[k]) {
                    g[k] = way;
                }
            }
        }
    }
}

fn centre(p: Point) -> Place {
    (2 * p.x as i32 + 1, 2 * p.y as i32 + 1)
}

/// The cell in which a way from this coordinate with this sign begins.
fn first_cell(at: i32, sign: i32) -> i32 {
    if at % 2 == 0 && sign < 0 { at / 2 - 1 } else { at / 2 }
}

/// In cells.
fn distance(a: Place, b: Place) -> f64 {
    let (dx, dy) = (f64::from(a.0 - b.0), f64::from(a.1 - b.1));
    0.5 * libm::sqrt(dx * dx + dy * dy)
}

fn same(a: Option<f64>, b: Option<f64>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => (a - b).abs() < 1e-9,
        _ => a == b,
    }
}

#[test]
fn it_is_the_shortest_way_over_all_corners() {
    let (mut found, mut bent) = (0, 0);
    for seed in 0..1500 {
        let (width, height) = (2 + seed * 7 % 17, 2 + seed * 5 % 13);
        let density = [0.1, 0.2, 0.3, 0.45][seed as usize % 4];
        let kind = [Generator::Random, Generator::Random, Generator::Cave, Generator::Rooms][(seed / 4) as usize % 4];
        let Ok(made) = generate(kind, width, height, seed, density) else { continue };
        for corner_rule in CornerRule::ALL {
            for moves in [Moves::Four, Moves::Eight, Moves::Sixteen] {
                let movement = Movement { moves, corner_rule };
                let Ok(scenario) = Scenario::on(made.grid.clone(), movement, made.start, made.goal) else { continue };
                let (length, expected) = (point_robot(&scenario).expect("small"), Plane::of(&scenario).shortest());
                assert!(same(length, expected), "{length:?}, not {expected:?}: {movement:?} {:?}", scenario.grid);
                found += u32::from(length.is_some());
                let straight = scenario.grid.point(scenario.start).distance(scenario.grid.point(scenario.goal));
                bent += u32::from(length.is_some_and(|length| length > straight + 1e-9));
            }
        }
    }
    assert!(found > 5000 && bent > 2000, "{found} ways, {bent} with bends");
}

/// How far it is from the goal to every cell.
fn field(scenario: &Scenario) -> Vec<f64> {
    let mut field = Field::new(scenario.grid.len());
    spread(&Obstacles::of(&scenario.grid, scenario.spec.movement), &scenario.grid, scenario.goal, &mut field);
    field.lengths
}

/// The same scenario from another cell.
fn starting_at(scenario: &Scenario, cell: Cell) -> Scenario {
    scenario.with_ends(scenario.grid.point(cell), scenario.spec.goals.clone()).expect("a free cell")
}

#[test]
fn a_field_has_the_shortest_way_to_every_cell() {
    let mut looked_at = 0;
    for (seed, corner_rule) in (0..60).zip(CornerRule::ALL.into_iter().cycle()) {
        let kind = [Generator::Random, Generator::Cave, Generator::Rooms][(seed / 3) as usize % 3];
        let made = generate(kind, 9 + seed % 8, 8 + seed % 7, seed, [0.08, 0.2, 0.35, 0.5][seed as usize % 4]).expect("a map");
        let movement = Movement { moves: Moves::Eight, corner_rule };
        let scenario = Scenario::on(made.grid, movement, made.start, made.goal).expect("usable");
        let lengths = field(&scenario);
        for cell in (0..scenario.grid.len() as Cell).step_by(3).filter(|&cell| !scenario.grid.is_blocked(cell)) {
            let expected = Plane::of(&starting_at(&scenario, cell)).shortest();
            let found = Some(lengths[cell as usize]).filter(|length| length.is_finite());
            assert!(same(found, expected), "{cell}: {found:?}, not {expected:?}: {movement:?} {:?}", scenario.grid);
            looked_at += 1;
        }
    }
    assert!(looked_at > 1000, "{looked_at} cells");
}

#[test]
fn on_large_maps_a_field_and_a_single_way_agree() {
    for (seed, density) in [(1, 0.02), (2, 0.1), (3, 0.3)] {
        let made = generate(Generator::Random, 300, 200, seed, density).expect("a map");
        let movement = Movement { moves: Moves::Eight, corner_rule: CornerRule::ALL[seed as usize % 3] };
        let scenario = Scenario::on(made.grid, movement, made.start, made.goal).expect("usable");
        let lengths = field(&scenario);
        for cell in (0..scenario.grid.len() as Cell).step_by(1999).filter(|&cell| !scenario.grid.is_blocked(cell)) {
            let way = point_robot(&starting_at(&scenario, cell)).expect("within its limit");
            assert!(same(Some(lengths[cell as usize]).filter(|length| length.is_finite()), way), "{cell}: {way:?}");
        }
    }
}
