//! A picture to look at.

use super::{Picture, over_white};

/// A picture in fewer pixels.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Small {
    /// Columns, at least 1.
    pub width: u32,
    /// Rows, at least 1.
    pub height: u32,
    /// Pixels of the picture that became one, along a row and along a column.
    pub by: u32,
    /// Red, green, blue and 255 of each pixel, row by row: `4 · width · height` bytes.
    pub rgba: Vec<u8>,
}

/// The picture over white, with at most `most` pixels a side (at least 1 is taken): the mean of every n × n pixels, with n as small as it
/// can be. Those that are left over at the right and below become pixels of their own.
pub fn small(picture: &Picture, most: u32) -> Small {
    let by = picture.width.max(picture.height).div_ceil(most.max(1)).max(1);
    let (width, height) = (picture.width.div_ceil(by), picture.height.div_ceil(by));
    let mut rgba = Vec::with_capacity(4 * width as usize * height as usize);
    for rows in picture.pixels.chunks(picture.width as usize * by as usize) {
        for column in 0..width as usize {
            rgba.extend(mean(rows, picture.width as usize, column * by as usize, by as usize));
        }
    }
    Small { width, height, by, rgba }
}

/// The mean colour of a block in some whole rows.
fn mean(rows: &[[u8; 4]], width: usize, from: usize, by: usize) -> [u8; 4] {
    let block = rows.chunks_exact(width).flat_map(|row| &row[from..width.min(from + by)]);
    let (count, sums) = block.fold((0_u32, [0_u32; 3]), |(count, [r, g, b]), &pixel| {
        let [red, green, blue] = over_white(pixel).map(u32::from);
        (count + 1, [r + red, g + green, b + blue])
    });
    let [r, g, b] = sums.map(|sum| ((sum + count / 2) / count.max(1)) as u8);
    [r, g, b, 255]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(width: u32, grays: &[u8]) -> Picture {
        let pixels: Vec<[u8; 4]> = grays.iter().map(|&gray| [gray, gray, gray, 255]).collect();
        Picture { width, height: pixels.len() as u32 / width, pixels, has_alpha: false, deep: None, notices: Vec::new() }
    }

    fn grays(small: &Small) -> Vec<u8> {
        small.rgba.chunks_exact(4).map(|pixel| pixel[0]).collect()
    }

    #[test]
    fn blocks_become_their_mean_and_what_is_left_over_stays() {
        let five = picture(3, &[0, 100, 7, 200, 100, 9, 40, 60, 30]);
        let whole = small(&five, 3);
        assert_eq!((whole.width, whole.by, grays(&whole)), (3, 1, vec![0, 100, 7, 200, 100, 9, 40, 60, 30]));
        let half = small(&five, 2);
        assert_eq!((half.width, half.height, half.by, grays(&half)), (2, 2, 2, vec![100, 8, 50, 30]));
        let one = small(&five, 0);
        assert_eq!((one.width, one.height, grays(&one)), (1, 1, vec![61]));
    }

    #[test]
    fn what_is_transparent_lies_over_white() {
        let clear = Picture { width: 1, height: 1, pixels: vec![[9, 9, 9, 0]], has_alpha: true, deep: None, notices: Vec::new() };
        assert_eq!(small(&clear, 9).rgba, [255; 4]);
    }
}
