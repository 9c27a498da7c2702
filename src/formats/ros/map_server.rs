//! Maps of ROS's map_server: a description in YAML, and a picture whose grays say how occupied a cell is. As nav2 reads them
//! (`nav2_map_server/src/map_io.cpp`): the thresholds are exclusive, alpha counts as a fourth colour in the mode `trinary`.

use super::costs::of_published;
use super::states::{self, FREE, OCCUPIED, States, UNKNOWN};
use super::without_tabs;
use super::yaml::{self, Value, required};
use crate::error::{FormatError, Notice};
use crate::formats::picture::Picture;
use crate::formats::text::quote;
use crate::scenario::World;

/// The gray that map_saver writes for unknown cells.
const SAVED_UNKNOWN: u8 = 205;

/// What map_saver writes as `free_thresh`.
const USUAL_FREE: f64 = 0.196;

/// How grays become occupancy.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Mode {
    /// Occupied, free, or unknown between the thresholds.
    Trinary,
    /// As trinary, but what is not opaque is unknown, and cells between the thresholds have a value between.
    Scale,
    /// The gray is the value: 0 to 100, above it unknown.
    Raw,
}

/// What a `map.yaml` says.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::formats) struct Description {
    /// The name of the picture, perhaps with folders.
    pub image: String,
    /// Metres per cell.
    pub resolution: f64,
    /// Where the map lies.
    pub world: World,
    mode: Mode,
    negate: bool,
    occupied: f64,
    free: f64,
    notices: Vec<Notice>,
}

impl Description {
    /// Reads a description.
    ///
    /// # Errors
    /// [`FormatError`] with the line of broken YAML, or the key at fault.
    pub fn read(text: &str) -> Result<Self, FormatError> {
        let document = yaml::read(&without_tabs(text))?;
        let image = document.get(&["image"]).and_then(Value::text).filter(|image| !image.trim().is_empty());
        let image = image.ok_or_else(|| FormatError::field("image", "missing", "the name of the picture, e.g. map.pgm"))?;
        let mut notices = Vec::new();
        let mut threshold = |key: &'static str, usual: f64| match document.get(&[key]) {
            None => {
                notices.push(unsaid(key, usual));
                Ok(usual)
            }
            Some(_) => {
                let value = required(&document, &[key], key, "a number from 0 to 1")?;
                let wrong = || FormatError::field(key, value.to_string(), "a number from 0 to 1");
                Some(value).filter(|v| (0.0..=1.0).contains(v)).ok_or_else(wrong)
            }
        };
        let (occupied, free) = (threshold("occupied_thresh", 0.65)?, threshold("free_thresh", USUAL_FREE)?);
        if free > occupied {
            return Err(FormatError::field(
                "free_thresh",
                format!("{free} is above occupied_thresh, {occupied}"),
                "a number below it",
            ));
        }
        let negate = negate(&document, &mut notices)?;
        Ok(Self {
            image: image.trim().into(),
            resolution: resolution(&document, &["resolution"])?,
            world: world(&document)?,
            mode: mode(&document)?,
            negate,
            occupied,
            free,
            notices,
        })
    }

    /// The cells of a picture, and what is worth saying; `as_costs`: values between free and occupied are costs.
    pub fn states(&self, picture: &Picture, as_costs: bool) -> (States, Vec<Notice>) {
        let mut notices = picture.notices.clone();
        notices.extend(self.notices.iter().cloned());
        let mut between = 0;
        let state = |(index, pixel): (usize, &[u8; 4])| {
            let shade = self.shade(picture, index);
            match self.value(shade, pixel[3]) {
                Some(value) if as_costs => return of_published(value),
                Some(value) => between += usize::from((1.0..=99.0).contains(&value)),
                None => {}
            }
            self.state(shade, pixel[3])
        };
        let cells: Vec<u8> = picture.pixels.iter().enumerate().map(state).collect();
        let states = States { width: picture.width, height: picture.height, cells };
        notices.extend(states::tell_of_values_between(between));
        notices.extend(self.trap(picture));
        (states, notices)
    }

    /// How light a pixel is, from 0 to 1.
    fn shade(&self, picture: &Picture, index: usize) -> f64 {
        if let Some(deep) = &picture.deep {
            return f64::from(deep[index]) / 65535.0;
        }
        self.shade_of(picture.pixels[index], picture.has_alpha)
    }

    fn shade_of(&self, [r, g, b, alpha]: [u8; 4], has_alpha: bool) -> f64 {
        let colours = f64::from(r) + f64::from(g) + f64::from(b);
        // Nav2 takes alpha for a fourth colour where the mode is trinary and the picture has it.
        match self.mode {
            Mode::Trinary if has_alpha => (colours + f64::from(alpha)) / 4.0 / 255.0,
            _ => colours / 3.0 / 255.0,
        }
    }

    fn state(&self, shade: f64, alpha: u8) -> u8 {
        if self.mode == Mode::Raw {
            return states::of_percent(libm::round(shade * 255.0), self.free, self.occupied);
        }
        match self.occupancy(shade) {
            _ if self.mode == Mode::Scale && alpha < 255 => UNKNOWN,
            o if o > self.occupied => OCCUPIED,
            o if o < self.free => FREE,
            _ => UNKNOWN,
        }
    }

    /// The value from 0 to 100 that map_server makes of a pixel; none where it is unknown, or in the mode `trinary`, which knows no values
    /// between.
    fn value(&self, shade: f64, alpha: u8) -> Option<f64> {
        match self.mode {
            Mode::Trinary => None,
            Mode::Raw => Some(libm::round(shade * 255.0)).filter(|value| *value <= 100.0),
            Mode::Scale if alpha < 255 => None,
            Mode::Scale => Some(match self.occupancy(shade) {
                o if o > self.occupied => 100.0,
                o if o < self.free => 0.0,
                // Where both thresholds are the same there is nothing between.
                _ if self.free == self.occupied => 0.0,
                o => libm::rint((o - self.free) / (self.occupied - self.free) * 100.0),
            }),
        }
    }

    fn occupancy(&self, shade: f64) -> f64 {
        if self.negate { shade } else { 1.0 - shade }
    }

    /// Maps whose unknown cells would be free: map_saver writes gray 205 for them, which is 0.196 occupied, and newer descriptions say that
    /// what is below 0.25 is free. With a channel of alpha, which counts as a fourth colour, they are lighter still.
    fn trap(&self, picture: &Picture) -> Option<Notice> {
        let saved = [SAVED_UNKNOWN, SAVED_UNKNOWN, SAVED_UNKNOWN, 255];
        let exact = |index: usize| picture.deep.as_ref().is_none_or(|deep| deep[index] == u16::from(SAVED_UNKNOWN) * 257);
        let count = picture.pixels.iter().enumerate().filter(|&(index, pixel)| *pixel == saved && exact(index)).count();
        let shade = self.shade_of(saved, picture.has_alpha);
        if count == 0 || self.mode == Mode::Raw || self.state(shade, 255) != FREE {
            return None;
        }
        let free = self.free;
        if self.occupancy(shade) < USUAL_FREE {
            let message = format!(
                "{count} cells have gray 205, which map_saver writes for unknown: they are free, since alpha counts as a fourth colour, as nav2 has it; save the picture without alpha"
            );
            return Some(Notice::new("ros-205-alpha", message).with("count", count));
        }
        let message = format!(
            "{count} cells have gray 205, which map_saver writes for unknown: they are free by the file's free_thresh of {free}; with 0.196 they would be unknown"
        );
        Some(Notice::new("ros-205", message).with("count", count).with("free", free))
    }
}

/// Metres per cell.
fn resolution(document: &Value, path: &[&str]) -> Result<f64, FormatError> {
    let value = required(document, path, "resolution", "metres per cell, above 0")?;
    Some(value)
        .filter(|&v| v > 0.0)
        .ok_or_else(|| FormatError::field("resolution", value.to_string(), "metres per cell, above 0"))
}

/// `origin: [x, y, yaw]`.
fn world(document: &Value) -> Result<World, FormatError> {
    const EXPECTED: &str = "[x, y, yaw] of the lower left corner, in metres and radians";
    let origin = document.get(&["origin"]).ok_or_else(|| FormatError::field("origin", "missing", EXPECTED))?;
    match origin.numbers() {
        Some(&[x, y, yaw]) if [x, y, yaw].iter().all(|v| v.is_finite()) => Ok(World { yaw, ..World::at(x, y) }),
        _ => Err(FormatError::field("origin", "not three numbers", EXPECTED)),
    }
}

/// The mode, in any case, as nav2 takes it.
fn mode(document: &Value) -> Result<Mode, FormatError> {
    let Some(given) = document.get(&["mode"]) else { return Ok(Mode::Trinary) };
    let given = given.text().unwrap_or("a list");
    match given.to_ascii_lowercase().as_str() {
        "trinary" => Ok(Mode::Trinary),
        "scale" => Ok(Mode::Scale),
        "raw" => Ok(Mode::Raw),
        _ => Err(FormatError::field("mode", format!("`{}`", quote(given)), "trinary, scale or raw")),
    }
}

fn negate(document: &Value, notices: &mut Vec<Notice>) -> Result<bool, FormatError> {
    match document.get(&["negate"]).map(|negate| negate.text().unwrap_or("a list")) {
        None => {
            notices.push(unsaid("negate", 0));
            Ok(false)
        }
        Some("0" | "false" | "False" | "no") => Ok(false),
        Some("1" | "true" | "True" | "yes") => Ok(true),
        Some(other) => Err(FormatError::field("negate", format!("`{}`", quote(other)), "0 or 1")),
    }
}

/// That a key is missing, and what is taken in its place.
fn unsaid(key: &str, usual: impl std::fmt::Display) -> Notice {
    let message = format!("the file has no {key}: {usual} is used, as map_saver writes it");
    Notice::new("ros-no-threshold", message).with("key", key).with("value", usual)
}
