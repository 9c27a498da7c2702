//! Gray of pixels, and the gray that parts dark from light.

use super::Picture;
use crate::error::Notice;
use crate::map::Window;

/// Luma of a pixel by ITU-R 601, 0–255: 0.299 red + 0.587 green + 0.114 blue, rounded.
pub fn luma([r, g, b]: [u8; 3]) -> u8 {
    ((299 * u32::from(r) + 587 * u32::from(g) + 114 * u32::from(b) + 500) / 1000) as u8
}

/// The colour of a pixel laid over white.
pub fn over_white([r, g, b, alpha]: [u8; 4]) -> [u8; 3] {
    let alpha = u32::from(alpha);
    [r, g, b].map(|c| ((u32::from(c) * alpha + 255 * (255 - alpha) + 127) / 255) as u8)
}

/// Gray of the pixels of a window, which must lie on the picture.
pub(super) fn gray(picture: &Picture, window: Window, notices: &mut Vec<Notice>) -> Vec<u8> {
    let mut gray = Vec::with_capacity(window.width as usize * window.height as usize);
    let mut clear = 0_u64;
    let rows = picture.pixels.chunks_exact(picture.width as usize).skip(window.y as usize).take(window.height as usize);
    for row in rows {
        for &pixel in &row[window.x as usize..][..window.width as usize] {
            clear += u64::from(pixel[3] < 255);
            gray.push(luma(over_white(pixel)));
        }
    }
    if clear > 0 {
        let message = format!("transparent pixels ({clear}) were laid over white");
        notices.push(Notice::new("picture-transparent", message).with("count", clear));
    }
    gray
}

/// Otsu's threshold of some values: those below it and the others differ most. 128 where there is one value only.
pub(in crate::formats) fn otsu(values: &[u8]) -> u8 {
    Histogram::new(values).otsu()
}

/// How many pixels have each gray.
pub(super) struct Histogram([u64; 256]);

impl Histogram {
    pub(super) fn new(grays: &[u8]) -> Self {
        let mut counts = [0; 256];
        grays.iter().for_each(|&gray| counts[usize::from(gray)] += 1);
        Self(counts)
    }

    /// The gray of all pixels, if it is one.
    pub(super) fn single(&self) -> Option<usize> {
        let mut present = (0..256).filter(|&gray| self.0[gray] > 0);
        present.next().filter(|_| present.next().is_none())
    }

    /// How many pixels have the grays of ROS's map_saver for free, occupied and unknown cells, where hardly any has another.
    pub(super) fn unknown_of_ros(&self) -> Option<u64> {
        let all: u64 = self.0.iter().sum();
        let own = self.0[254] + self.0[0] + self.0[205];
        (self.0[205] > 0 && self.0[254] > 0 && own >= all - all / 100).then_some(self.0[205])
    }

    /// Otsu's threshold: pixels below it and the others differ most, by the variance between the two. Of several that are as good the middle
    /// one is taken.
    pub(super) fn otsu(&self) -> u8 {
        let weighted = |(gray, &count): (usize, &u64)| gray as f64 * count as f64;
        let (all, sum) = (self.0.iter().sum::<u64>() as f64, self.0.iter().enumerate().map(weighted).sum::<f64>());
        let (mut below, mut sum_below) = (0.0, 0.0);
        let (mut best, mut first, mut last) = (0.0, 128, 128);
        for threshold in 1..256_usize {
            below += self.0[threshold - 1] as f64;
            sum_below += (threshold - 1) as f64 * self.0[threshold - 1] as f64;
            let above = all - below;
            if below == 0.0 || above == 0.0 {
                continue;
            }
            let difference = sum_below / below - (sum - sum_below) / above;
            let between = below * above * difference * difference;
            if between > best {
                (best, first) = (between, threshold);
            }
            if between == best {
                last = threshold;
            }
        }
        ((first + last) / 2) as u8
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn luma_is_exact_for_gray() {
        for v in 0..=255 {
            assert_eq!(luma([v; 3]), v);
            assert_eq!(over_white([v, v, v, 255]), [v; 3]);
            assert_eq!(over_white([v, v, v, 0]), [255; 3]);
        }
        assert_eq!([luma([255, 0, 0]), luma([0, 255, 0]), luma([0, 0, 255])], [76, 150, 29]);
        assert_eq!(over_white([0, 0, 0, 128]), [127; 3]);
    }

    #[test]
    fn two_grays_are_parted_in_their_middle() {
        let histogram = Histogram::new(&[0, 255, 255]);
        assert_eq!(histogram.otsu(), 128);
        assert_eq!(histogram.single(), None);
        assert_eq!(Histogram::new(&[7, 7]).single(), Some(7));
        assert_eq!(Histogram::new(&[10, 11, 12, 90, 91, 92]).otsu(), (13 + 90) / 2);
    }
}
