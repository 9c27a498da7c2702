use super::*;
use crate::map::{MoveSet, Movement, Moves};

const SIZES: [(u32, u32); 12] =
    [(1, 1), (1, 2), (2, 1), (2, 2), (1, 40), (3, 3), (4, 5), (5, 5), (6, 6), (7, 30), (20, 20), (65, 48)];

fn connected(made: &Generated, moves: Moves) -> bool {
    let movement = Movement { moves, ..Movement::default() };
    let (start, goal) = (made.grid.cell(made.start), made.grid.cell(made.goal));
    MoveSet::new(&made.grid, movement).connected(start, goal)
}

#[test]
fn ends_are_free_and_connected_for_every_kind_and_size() {
    for kind in Generator::ALL {
        for (w, h) in SIZES {
            for seed in 0..20 {
                for density in [0.0, 0.3, MAX_DENSITY] {
                    let made = generate(kind, w, h, seed, density).unwrap();
                    assert!(!made.grid.is_blocked(made.grid.cell(made.start)), "{kind:?} {w}×{h} seed {seed}");
                    assert!(!made.grid.is_blocked(made.grid.cell(made.goal)), "{kind:?} {w}×{h} seed {seed}");
                    assert!(connected(&made, Moves::Four), "{kind:?} {w}×{h} seed {seed}");
                    assert!(connected(&made, Moves::Eight), "{kind:?} {w}×{h} seed {seed}");
                }
            }
        }
    }
}

#[test]
fn start_is_upper_left_and_goal_lower_right() {
    for kind in Generator::ALL {
        for seed in 0..20 {
            let made = generate(kind, 60, 40, seed, 0.3).unwrap();
            assert!(made.start.x + made.start.y <= 24, "{kind:?} seed {seed}: {:?}", made.start);
            assert!(59 - made.goal.x + 39 - made.goal.y <= 24, "{kind:?} seed {seed}: {:?}", made.goal);
        }
    }
}

#[test]
fn same_seed_same_map_and_other_seed_another() {
    for kind in Generator::ALL {
        let make = |seed| generate(kind, 40, 41, seed, 0.3).unwrap();
        assert_eq!(make(7), make(7), "{kind:?}");
        assert_ne!(make(7), make(8), "{kind:?}");
    }
}

#[test]
fn maps_keep_their_bits_from_version_to_version() {
    let digest = |kind| {
        let made = generate(kind, 64, 48, 1, 0.3).unwrap();
        let mut digest = crate::digest::Digest::default();
        digest.bytes(&made.grid.to_bytes());
        made.grid.heights().iter().flat_map(|h| h.iter()).for_each(|h| digest.bytes(&h.to_le_bytes()));
        digest.hex()
    };
    let golden = [
        "2c632ca1d68b3b45",
        "fd359060835c17a6",
        "6121c2df948c6a04",
        "79eee4b11e1b285f",
        "5bf0800ed0d18a4e",
        "d16b3a0d94798f7f",
        "479969d69fde95d5",
        "e66abdfd28e817a1",
    ];
    assert_eq!(Generator::ALL.map(digest), golden);
}

#[test]
fn terrains_rise_from_0_to_their_relief() {
    for kind in [Generator::Fractal, Generator::Hills] {
        for (w, h) in [(2, 2), (21, 21), (40, 90), (257, 129)] {
            for roughness in [0.0, 0.5, MAX_DENSITY] {
                let made = generate(kind, w, h, 3, roughness).unwrap();
                let heights = made.grid.heights().unwrap();
                let (low, high) = heights.iter().fold((f32::MAX, f32::MIN), |(l, h), &v| (l.min(v), h.max(v)));
                let relief = (0.12 * 30.0 * f64::from(w.max(h)) * 10.0).round() / 10.0;
                assert_eq!((low, high, made.resolution), (0.0, relief as f32, 30.0), "{kind:?} {w}×{h} {roughness}");
                assert_eq!(made.grid.free_count(), made.grid.len());
            }
        }
    }
}

#[test]
fn rough_ground_is_steeper() {
    for kind in [Generator::Fractal, Generator::Hills] {
        let steepness = |roughness| -> f64 {
            let makes = (0..20).map(|seed| generate(kind, 128, 128, seed, roughness).unwrap());
            let climb = |heights: &[f32]| heights.windows(2).map(|h| f64::from((h[1] - h[0]).abs())).sum::<f64>();
            makes.map(|made| climb(made.grid.heights().unwrap())).sum()
        };
        let steep = [0.0, 0.3, 0.6, 0.9].map(steepness);
        assert!(steep.is_sorted(), "{kind:?}: {steep:?}");
    }
}

#[test]
fn a_maze_is_a_tree() {
    for (w, h) in [(5, 5), (6, 7), (20, 20), (21, 21), (64, 48)] {
        let grid = generate(Generator::Maze, w, h, 3, 0.0).unwrap().grid;
        let free = |x: i64, y: i64| u32::from(grid.is_free_at(x, y));
        let links: u32 = (0..i64::from(h))
            .flat_map(|y| (0..i64::from(w)).map(move |x| (x, y)))
            .map(|(x, y)| free(x, y) * (free(x + 1, y) + free(x, y + 1)))
            .sum();
        assert_eq!(links as usize + 1, grid.free_count(), "{w}×{h}: connected with n − 1 links");
    }
}

#[test]
fn density_is_kept_and_checked() {
    let made = generate(Generator::Random, 200, 200, 5, 0.3).unwrap();
    let share = 1.0 - made.grid.free_count() as f64 / 40_000.0;
    assert!((share - 0.3).abs() < 0.01, "{share}");
    for kind in [Generator::Random, Generator::Blocks, Generator::Bars] {
        for density in [-0.1, 0.95, f64::NAN] {
            let refused = generate(kind, 9, 9, 0, density).unwrap_err();
            assert!(refused.to_string().starts_with("density"), "{kind:?}: {refused}");
        }
    }
    for density in [-0.1, 0.95, f64::NAN] {
        let refused = generate(Generator::Hills, 9, 9, 0, density).unwrap_err();
        assert!(refused.to_string().starts_with("roughness"), "{refused}");
    }
    assert!(generate(Generator::Cave, 0, 9, 0, 0.0).is_err());
}

fn blocked(grid: &Grid) -> usize {
    grid.len() - grid.free_count()
}

/// The rows and columns that a block takes, by the block of its upper-left cell.
fn blocks_of(grid: &Grid) -> Vec<[u32; 4]> {
    let is_free = |x: u32, y: u32| grid.is_free_at(i64::from(x), i64::from(y)) || x >= grid.width() || y >= grid.height();
    let mut found = Vec::new();
    for cell in (0..grid.len() as u32).filter(|&c| grid.is_blocked(c)) {
        let Point { x, y } = grid.point(cell);
        let is_corner = (x == 0 || is_free(x - 1, y)) && (y == 0 || is_free(x, y - 1));
        if is_corner {
            let width = (1..).find(|&w| is_free(x + w, y)).unwrap();
            let height = (1..).find(|&h| is_free(x, y + h)).unwrap();
            found.push([x, y, width, height]);
        }
    }
    found
}

#[test]
fn blocks_are_rectangles_with_aisles_between_them() {
    for ((w, h), longest) in [((20, 20), 4), ((30, 30), 6), ((40, 30), 6), ((90, 60), 8), ((9, 30), 1)] {
        let mut sides = [false; 9];
        for seed in 0..20 {
            let grid = generate(Generator::Blocks, w, h, seed, 0.2).unwrap().grid;
            let blocks = blocks_of(&grid);
            assert_eq!(
                blocks.iter().map(|b| (b[2] * b[3]) as usize).sum::<usize>(),
                blocked(&grid),
                "{w}×{h} seed {seed}: rectangles"
            );
            for (i, &[x, y, width, height]) in blocks.iter().enumerate() {
                assert!(width.max(height) <= longest, "{w}×{h} seed {seed}: {width} × {height}");
                sides[width as usize] = true;
                sides[height as usize] = true;
                for &[u, v, wide, high] in &blocks[..i] {
                    let is_apart = u + wide < x || x + width < u || v + high < y || y + height < v;
                    assert!(is_apart, "{w}×{h} seed {seed}: blocks at {x},{y} and {u},{v} touch");
                }
            }
        }
        assert!(sides[1..=longest as usize].iter().all(|&seen| seen), "{w}×{h}: {sides:?}");
    }
}

/// How many cells of wall follow one another at each place, along rows and columns; single cells are left out.
fn stretches(grid: &Grid) -> Vec<u32> {
    let is_wall = |x: i64, y: i64| x < i64::from(grid.width()) && y < i64::from(grid.height()) && !grid.is_free_at(x, y);
    let mut found = Vec::new();
    for cell in 0..grid.len() as u32 {
        let p = grid.point(cell);
        let (x, y) = (i64::from(p.x), i64::from(p.y));
        for (dx, dy) in [(1, 0), (0, 1)] {
            let begins = is_wall(x, y) && (x < dx || y < dy || !is_wall(x - dx, y - dy));
            let length = (0..).find(|&n| !is_wall(x + n * dx, y + n * dy)).unwrap_or(0);
            found.extend((begins && length > 1).then_some(length as u32));
        }
    }
    found
}

#[test]
fn bars_are_straight_and_of_different_lengths() {
    for (w, h) in [(20, 20), (40, 30)] {
        let longest = 2 * w / 5;
        let mut seen = vec![0; 2 * w as usize];
        for seed in 0..40 {
            let grid = generate(Generator::Bars, w, h, seed, 0.05).unwrap().grid;
            let walls = stretches(&grid);
            walls.iter().for_each(|&length| seen[length as usize] += 1);
            // No cell stands alone but what the last wall leaves, and what an end or an opening cuts off.
            let is_alone = |c: &u32| {
                let (x, y) = (i64::from(grid.point(*c).x), i64::from(grid.point(*c).y));
                [(-1, 0), (1, 0), (0, -1), (0, 1)].iter().all(|(dx, dy)| grid.is_free_at(x + dx, y + dy))
            };
            let inner = |c: &u32| (1..w - 1).contains(&grid.point(*c).x) && (1..h - 1).contains(&grid.point(*c).y);
            let alone = (0..grid.len() as u32).filter(|c| grid.is_blocked(*c) && inner(c) && is_alone(c)).count();
            assert!(alone <= 1, "{w}×{h} seed {seed}: {alone} cells alone");
        }
        assert!(seen[2..=longest as usize].iter().all(|&times| times > 0), "{w}×{h}: {seen:?}");
        // Longer ones are two walls in one row that touch.
        let [fit, longer] = [&seen[..=longest as usize], &seen[longest as usize + 1..]].map(|times| times.iter().sum::<u32>());
        assert!(longer * 20 < fit, "{w}×{h}: {seen:?}");
    }
}

#[test]
fn blocks_and_bars_cover_the_density_to_the_cell() {
    for (w, h) in [(20, 20), (30, 30), (40, 30), (100, 70)] {
        for seed in 0..20 {
            let covered = |kind, density| blocked(&generate(kind, w, h, seed, density).unwrap().grid);
            let asked = |density: f64| (density * f64::from(w * h)) as usize;
            for density in [0.0, 0.1, 0.2] {
                assert_eq!(covered(Generator::Blocks, density), asked(density), "{w}×{h} seed {seed} density {density}");
            }
            // More than fits: as many as there is room for.
            assert!(covered(Generator::Blocks, MAX_DENSITY) > asked(0.25), "{w}×{h} seed {seed}");
            for density in [0.0, 0.1, 0.3, MAX_DENSITY] {
                let (covered, asked) = (covered(Generator::Bars, density), asked(density));
                let opened = (w + h) as usize;
                assert!(covered <= asked && covered + opened >= asked, "{w}×{h} seed {seed}: {covered} of {asked}");
                if density == 0.1 {
                    assert!(covered + 3 >= asked, "{w}×{h} seed {seed}: {covered} of {asked}");
                }
            }
        }
    }
}
