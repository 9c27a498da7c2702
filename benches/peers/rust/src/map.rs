//! A map as `formicarium` writes it: JSON whose `map.rows` are rows of `.` and `@`.

use serde_json::Value;

/// Which cells are walls.
pub struct Map {
    pub width: i32,
    pub height: i32,
    walls: Vec<bool>,
}

impl Map {
    pub fn read(file: &str) -> Self {
        let text = std::fs::read_to_string(file).expect("a map");
        let scenario: Value = serde_json::from_str(&text).expect("JSON");
        let rows = scenario["map"]["rows"].as_array().expect("rows");
        let walls: Vec<bool> = rows.iter().flat_map(|row| row.as_str().expect("a row").bytes().map(|b| b == b'@')).collect();
        let height = rows.len();
        Self { width: (walls.len() / height) as i32, height: height as i32, walls }
    }

    pub fn is_free(&self, x: i32, y: i32) -> bool {
        let inside = 0 <= x && x < self.width && 0 <= y && y < self.height;
        inside && !self.walls[(y * self.width + x) as usize]
    }
}
