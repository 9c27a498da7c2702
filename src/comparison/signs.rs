//! What signs alone tell over maps: the sign test, and the interval of a median from the order of a sample. Both count heads of a fair coin,
//! exactly, and ask nothing of how the values are distributed.

/// Two-sided p of the sign test (Dixon and Mood 1946): so many of one sign against so many of the other; what is 0 is left out before. None
/// where nothing has a sign.
pub(super) fn sign_test(above: usize, below: usize) -> Option<f64> {
    let n = above + below;
    let tail: f64 = (0..=above.min(below)).map(|heads| exactly(heads, n)).sum();
    (n > 0).then(|| (2.0 * tail).min(1.0))
}

/// Which place in the order, from 1, counted from either end, bounds an interval of the median that holds at least at a confidence, and at
/// which it does (Conover 1999, section 3.2). None where even the whole sample is too few.
pub(super) fn median_places(n: usize, confidence: f64) -> Option<(usize, f64)> {
    let mut outside = 0.0;
    let places = (1..=n / 2).map(|place| {
        outside += 2.0 * exactly(place - 1, n);
        (place, 1.0 - outside)
    });
    places.take_while(|(_, holds)| *holds >= confidence).last()
}

/// That interval of an ascending sample.
pub(super) fn median_within(ascending: &[f64], confidence: f64) -> Option<([f64; 2], f64)> {
    let (place, holds) = median_places(ascending.len(), confidence)?;
    Some(([ascending[place - 1], ascending[ascending.len() - place]], holds))
}

/// How likely so many of n tosses of a fair coin are heads: by the ways themselves as far as a number holds them, then by their logarithm.
fn exactly(heads: usize, n: usize) -> f64 {
    const COUNTED: usize = 1000;
    if n <= COUNTED {
        let ways = (1..=heads).fold(1.0, |ways, i| ways * (n - heads + i) as f64 / i as f64);
        return libm::scalbn(ways, -(n as i32));
    }
    let log = |m: usize| libm::lgamma(m as f64 + 1.0);
    libm::exp(log(n) - log(heads) - log(n - heads) - n as f64 * std::f64::consts::LN_2)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: f64, b: f64) {
        assert!((a - b).abs() <= 1e-12, "{a} is not {b}");
    }

    #[test]
    fn the_sign_test_is_scipys() {
        // scipy.stats.binomtest(k, n).pvalue, SciPy 1.17.1.
        for (above, below, p) in [
            (5, 1, 0.218_75),
            (12, 3, 0.035_156_25),
            (8, 8, 1.0),
            (14, 1, 0.000_976_562_5),
            (0, 6, 0.031_25),
            (60, 40, 0.056_887_933_640_980_89),
            (700, 600, 0.006_015_793_861_044_94),
        ] {
            close(sign_test(above, below).unwrap(), p);
        }
        assert_eq!((sign_test(0, 0), sign_test(7, 7)), (None, Some(1.0)));
    }

    #[test]
    fn places_are_those_of_the_tables() {
        // Conover's and every other table: n = 15 → 4th and 12th, 96.48 %; below 6 nothing holds at 95 %.
        for (n, place, holds) in [
            (6, 1, 0.968_75),
            (8, 1, 0.992_187_5),
            (9, 2, 0.960_937_5),
            (15, 4, 0.964_843_75),
            (16, 4, 0.978_729_248_046_875),
            (20, 6, 0.958_610_534_667_968_8),
            (25, 8, 0.956_714_749_336_242_7),
            (50, 18, 0.967_160_862_435_731_5),
        ] {
            let (found, at) = median_places(n, 0.95).unwrap();
            assert_eq!(found, place, "{n}");
            close(at, holds);
        }
        assert!((0..6).all(|n| median_places(n, 0.95).is_none()));
        // At 90 %: 1 − 2 · 32/512 and 1 − 2/64.
        assert_eq!(median_places(9, 0.9).map(|(place, _)| place), Some(2));
        assert_eq!(median_places(5, 0.9).map(|(place, _)| place), Some(1));
        let of = |n: u32| (1..=n).map(f64::from).collect::<Vec<_>>();
        assert_eq!(median_within(&of(15), 0.95).unwrap().0, [4.0, 12.0]);
        assert_eq!(median_within(&of(6), 0.95).unwrap().0, [1.0, 6.0]);
    }
}
