//! Fewer cells of the same ground.

/// A size scaled down evenly, rounded, until its longer side is `side`, which is at most that.
pub(super) fn at_most((width, height): (u32, u32), side: u32) -> (u32, u32) {
    let longer = u64::from(width.max(height).max(1));
    let scaled = |n: u32| ((u64::from(n) * u64::from(side) + longer / 2) / longer).max(1) as u32;
    (scaled(width), scaled(height))
}

/// The same ground in `to` (columns, rows) cells instead of `from`: each becomes the largest of the cells that it covers, so that states are
/// to be numbered from the best to the worst, as 0 free < 1 unknown < 2 blocked. Cell x of w covers ⌊x·W/w⌋ to ⌈(x+1)·W/w⌉ − 1 of W: whole
/// cells, each at least once. `cells` has `from.0 · from.1` of them, row by row; what is missing counts as 0. Any sides are allowed; a side
/// of 0 gives no cells.
pub fn shrink_worst(cells: &[u8], from: (u32, u32), to: (u32, u32)) -> Vec<u8> {
    if from == to {
        return cells.to_vec();
    }
    let wide = from.0 as usize;
    let mut worst = Vec::with_capacity(to.0 as usize * to.1 as usize);
    let mut row = vec![0; wide];
    for y in 0..to.1 {
        row.fill(0);
        let (first, end) = covered(y, from.1, to.1);
        for line in cells.chunks(wide.max(1)).take(end).skip(first) {
            row.iter_mut().zip(line).for_each(|(worst, &cell)| *worst = cell.max(*worst));
        }
        worst.extend((0..to.0).map(|x| {
            let (first, end) = covered(x, from.0, to.0);
            row.get(first..end).and_then(|part| part.iter().max()).copied().unwrap_or(0)
        }));
    }
    worst
}

/// The first of `from` cells that cell `i` of `to` covers, and the one behind the last.
fn covered(i: u32, from: u32, to: u32) -> (usize, usize) {
    let (i, from, to) = (u64::from(i), u64::from(from), u64::from(to));
    ((i * from / to) as usize, ((i + 1) * from).div_ceil(to) as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_worst_of_what_is_covered() {
        let cells = [0, 1, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1];
        assert_eq!(shrink_worst(&cells, (5, 3), (5, 3)), cells);
        assert_eq!(shrink_worst(&cells, (5, 3), (1, 1)), [2]);
        // The middle column is covered by both halves, and the middle row.
        assert_eq!(shrink_worst(&[0, 1, 0], (3, 1), (2, 1)), [1, 1]);
        assert_eq!(shrink_worst(&[1, 0, 0], (3, 1), (2, 1)), [1, 0]);
        assert_eq!(shrink_worst(&[0, 0, 2, 0], (2, 2), (2, 1)), [2, 0]);
        assert_eq!(shrink_worst(&[3, 4], (2, 1), (4, 2)), [3, 3, 4, 4, 3, 3, 4, 4]);
    }

    #[test]
    fn nothing_is_left_out() {
        for from in 1..40 {
            for to in 1..=from {
                let mut seen = vec![0; from as usize];
                for i in 0..to {
                    let (first, end) = covered(i, from, to);
                    assert!(first < end && end <= from as usize);
                    seen[first..end].iter_mut().for_each(|n| *n += 1);
                }
                assert!(seen.iter().all(|&n| n == 1 || n == 2), "{from} to {to}");
            }
        }
    }

    #[test]
    fn short_and_empty_inputs() {
        assert_eq!(shrink_worst(&[], (4, 4), (2, 2)), [0; 4]);
        assert!(shrink_worst(&[], (0, 0), (0, 3)).is_empty());
        assert_eq!(shrink_worst(&[], (0, 0), (1, 1)), [0]);
    }

    #[test]
    fn sides_keep_their_proportion() {
        assert_eq!(at_most((5000, 2500), 4096), (4096, 2048));
        assert_eq!(at_most((10, 10_000), 100), (1, 100));
        assert_eq!(at_most((300, 200), 300), (300, 200));
    }
}
