//! What a file may be.

use serde::{Deserialize, Serialize};

/// What a file is. Serialized as `movingai-map`, `movingai-scen`, `matrix`, `drawing`, … `unknown`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Kind {
    /// A map of the MovingAI benchmarks.
    MovingaiMap,
    /// A list of scenarios of the MovingAI benchmarks.
    MovingaiScen,
    /// Numbers in rows and columns, alone or in a program.
    Matrix,
    /// A map drawn with letters: `#` and `.`.
    Drawing,
    /// Heights as an ESRI ASCII grid.
    EsriAscii,
    /// Heights in rows and columns.
    HeightTable,
    /// Heights as a GeoTIFF.
    Geotiff,
    /// Heights as an SRTM tile.
    Srtm,
    /// A picture: PNG, JPEG, WebP, BMP, PGM and its kin.
    Picture,
    /// The description of a map of ROS's map_server, which names its picture.
    RosMap,
    /// An OccupancyGrid message of ROS, as `ros2 topic echo` prints it.
    OccupancyGrid,
    /// An instance of multi-agent path finding, as YAML.
    Mapf,
    /// An instance of TSPLIB.
    Tsplib,
    /// A tour of such an instance.
    TsplibTour,
    /// A path: a Path message of ROS, or pairs in brackets.
    Path,
    /// A scenario with its map, as JSON.
    Scenario,
    /// A race as it is shared (`formicarium/experiment@1` or `@2`), as JSON.
    Session,
    /// Many runs with their question and maps, as JSON.
    Comparison,
    /// The runs of a comparison that one process or one browser tab has done.
    Journal,
    /// Runs from elsewhere, as a table or a data file of IOHanalyzer or COCO.
    Results,
    /// A ZIP or gzip archive.
    Archive,
    /// None of these.
    Unknown,
}

impl Kind {
    /// Whether files of this kind are rasters of heights.
    pub const fn is_raster(self) -> bool {
        matches!(self, Self::EsriAscii | Self::HeightTable | Self::Geotiff | Self::Srtm)
    }

    /// Whether a map can be made of files of this kind.
    pub const fn holds_cells(self) -> bool {
        self.is_raster()
            || matches!(
                self,
                Self::MovingaiMap
                    | Self::Matrix
                    | Self::Drawing
                    | Self::Picture
                    | Self::RosMap
                    | Self::OccupancyGrid
                    | Self::Mapf
                    | Self::Scenario
            )
    }

    /// What to call it, with its article.
    pub const fn name(self) -> &'static str {
        match self {
            Self::MovingaiMap => "a map of the MovingAI benchmarks",
            Self::MovingaiScen => "a list of MovingAI scenarios",
            Self::Matrix => "a matrix of free and blocked cells",
            Self::Drawing => "a map drawn with letters",
            Self::EsriAscii => "an ESRI ASCII grid",
            Self::HeightTable => "a table of heights",
            Self::Geotiff => "a GeoTIFF",
            Self::Srtm => "an SRTM tile",
            Self::Picture => "a picture",
            Self::RosMap => "the description of a ROS map",
            Self::OccupancyGrid => "an OccupancyGrid message",
            Self::Mapf => "an instance of multi-agent path finding",
            Self::Tsplib => "an instance of TSPLIB",
            Self::TsplibTour => "a tour of TSPLIB",
            Self::Path => "a path",
            Self::Scenario => "a scenario",
            Self::Session => "a session",
            Self::Comparison => "a comparison",
            Self::Journal => "a journal of a comparison's runs",
            Self::Results => "a table of results",
            Self::Archive => "an archive",
            Self::Unknown => "of no known format",
        }
    }
}
