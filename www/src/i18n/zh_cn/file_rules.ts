import type { Phrases } from '../phrases'

/** What a format asks for, as the engine says it after “expected”. */
export const zhCNFileRules: Phrases = {
  // Numbers and texts anywhere.
  numbers: '数字',
  'a number': '一个数',
  'a value': '一个值',
  'at most one': '至多一个',
  'one of the two': '二者之一',
  'as many': '数目相同',
  'a field that is left out where there is none': '没有时应省去该字段',
  'an object with the names {}': '含有这些名称的对象：{}',
  '0 and 1': '0 与 1',
  '0 or 1': '0 或 1',
  '{} to {}': '{} 至 {}',
  'a whole number, at least 1': '不小于 1 的整数',
  'a whole number from {} to {}': '{} 至 {} 的整数',
  'a number from {} to {}': '{} 至 {} 的数',
  'a number in decimal digits': '十进制数字',
  'the whole file': '完整的文件',
  'text in UTF-8': 'UTF-8 文本',
  'each key once': '每个键只出现一次',
  '{} MiB': '{} MiB',
  '{} files': '{} 个文件',
  '{} lines': '{} 行',
  '{} pixels a side': '每边 {} 像素',
  '{} cells': '{} 格',
  '{} million cells': '{}00 万格',
  '{} million pixels': '{}00 万像素',
  '{} MiB of memory': '{} MiB 内存',

  // Matrices and drawings.
  'rows of 0 and 1': '由 0 与 1 组成的行',
  'equally long rows': '各行等长',
  'numbers in every row': '每行都有数字',
  'a `]` after the last row': '最后一行之后有“]”',
  'rows of numbers: 0 for free, 1 for blocked': '成行的数字：0 为空闲，1 为障碍',
  'rows of numbers, or a bracket of numbers with at least two rows and two columns':
    '成行的数字，或括号中至少两行两列的数字',
  'one matrix: rows of numbers within one bracket': '一个矩阵：同一括号中成行的数字',
  'a number in every field: 0 for free, 1 for blocked': '每个字段都有数：0 为空闲，1 为障碍',
  'the same rows in every block of columns': '每块列的行数相同',
  'every column once, from the first to the last': '从第一列到最后一列，各出现一次',
  'all of them: in NumPy, np.set_printoptions(threshold=sys.maxsize) before it is printed, or np.savetxt':
    '全部数字：在 NumPy 中打印之前使用 np.set_printoptions(threshold=sys.maxsize)，或使用 np.savetxt',
  'decimal points, or nothing but commas between numbers': '小数点，或数字之间只用逗号',
  'numbers with a decimal point, and nothing between thousands': '带小数点且没有千位分隔符的数',
  'a line without labels; or names such as a,b,c above the columns':
    '不带标签的行；或各列之上有 a,b,c 之类的名称',
  'a grid of cells; a path is checked by `formicarium check`':
    '格子组成的栅格；路径可用 formicarium check 检验',
  'a grid: gdal_translate in.xyz out.asc, or gdal_grid for scattered points':
    '栅格：gdal_translate in.xyz out.asc，散点可用 gdal_grid',
  'heights alone in rows and columns, without names above, or an ESRI ASCII grid':
    '只有高程的行与列，上方没有名称；或 ESRI ASCII 栅格',
  '# . and S, G': '#、. 与 S、G',
  'one start (S or A) and one goal (G, E or B)': '一个起点（S 或 A）与一个终点（G、E 或 B）',

  // MovingAI and JSON.
  'the end of the file, or a larger `height`': '文件到此结束，或更大的 height',
  'each header line once': '文件头的每一行只出现一次',
  'a number of cells, e.g. 512': '格数，例如 512',
  'a line `{}` above': '上方有一行 {}',
  'a line `{}`': '有一行 {}',
  'one line for each row': '每行一排格子',
  '. G S E (free) or @ O T W (blocked)': '. G S E（空闲）或 @ O T W（障碍）',
  '{} terrain letters': '{} 个地形字符',
  '`type octile`, `height N`, `width N`, then `map`': 'type octile、height N、width N，然后是 map',
  'as many corners as the header says, or one more a side': '角点数与文件头相同，或每边多一个',
  'bucket, map, width, height, start x, start y, goal x, goal y, optimal length':
    'bucket、地图、宽、高、起点 x、起点 y、终点 x、终点 y、最优长度',
  'a JSON object': 'JSON 对象',
  'an object with "format": "{}"': '带有 "format": "{}" 的对象',
  'only {} here': '此处只能有 {}',
  '{"rows": ["..@.", …]} with `.` for free and `@` for blocked':
    '{"rows": ["..@.", …]}，. 为空闲，@ 为障碍',
  '"heights": [[12.5, 13, null, …], …], one number for each cell, `null` for no data':
    '"heights": [[12.5, 13, null, …], …]，每格一个数，null 表示没有数据',
  '"factors": [[1, 2.5, 1, …], …], one number for each cell, 1 to 1000':
    '"factors": [[1, 2.5, 1, …], …]，每格一个数，1 至 1000',
  'one map for each instance': '每个实例一张地图',
  'a comparison as `compare` or the page writes it': '由 compare 或本页写出的比较',
  'the fields of docs/formats.md': 'docs/formats.md 所列的字段',

  // Paths.
  'places without levels: column and row': '不带层的位置：列与行',
  'at least its start and its goal': '至少有起点与目标',
  'a shorter path': '更短的路径',
  'one level for each cell': '每格一个层',
  'places on the map: check against the one that the path was planned on':
    '地图上的位置：请与规划此路径的地图一起检验',
  'x and y, or row and col, once each': 'x 与 y，或 row 与 col，各一次',
  'pairs of whole numbers: [[x, y], …], lines `x,y`, or [x y; x y]; by slices each with its level':
    '整数对：[[x, y], …]、每行 x,y，或 [x y; x y]；按切片时各带所在层',
  'a map that knows its place in the world: check it against the ROS map':
    '带有世界坐标的地图：请与 ROS 地图一起检验',
  'an object of JSON': 'JSON 对象',
  'a path on this map, from its start by every goal': '此地图上从起点经过每个目标的路径',
  'a map with `world` in its scenario, whose `frame` is a code such as EPSG:25832; path-json and nav-msgs need none':
    '场景中有 world 的地图，其 frame 是 EPSG:25832 之类的代码；path-json 与 nav-msgs 不需要',
  'a place of the map nearer to zero': '离原点更近的地图位置',
  'a Feature, or a collection of one, whose geometry is a LineString of [x, y] or [x, y, z]':
    '一个要素，或只有一个要素的集合，其几何为 [x, y] 或 [x, y, z] 组成的 LineString',
  'a name such as urn:ogc:def:crs:EPSG::25832': 'urn:ogc:def:crs:EPSG::25832 之类的名称',
  '`cells`: [[x, y], …], and by slices `levels`: [level, …]':
    'cells：[[x, y], …]，按切片时还有 levels：[level, …]',
  'the drawing as `plan --format svg` writes it, with whole numbers `x,y` as the points of its line':
    'plan --format svg 写出的图形，其线上的点为整数 x,y',
  'a map that knows its place in the world': '带有世界坐标的地图',

  // Pictures and figures.
  'a length above 0': '大于 0 的长度',
  'at least one pixel': '至少一个像素',
  'at least {} m: a pixel, and no more than {} cells a side':
    '至少 {} 米：一个像素，且每边不超过 {} 格',
  'walls and free space in different grays; crop it to where the map is':
    '墙与空地灰度不同；请裁剪到地图所在之处',
  'a {} as its specification describes it': '符合规范的 {}',
  'one blank': '一个空白',
  'a number for each pixel': '每像素一个数',
  'whole rows of cells': '完整的各行格子',
  'classes from {} to {}': '类别 {} 至 {}',
  'a corner on or near the picture': '位于图片上或其附近的角',
  'cells of at least 3 × 3 pixels': '每格至少 3 × 3 像素',
  'less than half a cell': '不到半格',
  '1 to 512 columns and rows': '1 至 512 列与行',
  'cells of one size, at least 4 × 4 of 5 pixels; give its lattice (--lattice on the command line), or read it as a picture by its --threshold':
    '大小一致的格子，至少 4 × 4 格、每格 5 像素；请给出网格（命令行用 --lattice），或作为图片按阈值读取（--threshold）',
  'either a figure, whose lattice and colours say it all, or a picture with this option':
    '或为网格图，由网格与颜色决定一切；或为使用此选项的图片',
  'a picture of a grid, or another file without `figure`': '网格的图片，或不带 figure 的其他文件',

  // Archives.
  'a ZIP archive that is whole, without a password': '完整且没有密码的 ZIP 压缩包',
  'an archive that is whole': '完整的压缩包',

  // Tables of results.
  'each column once': '每列只出现一次',
  'one line a run': '每行一次运行',
  'a line of column names, then one line a run': '一行列名，然后每行一次运行',
  'a line of names first, one of them `length` (or `value`); between commas, semicolons or tabs':
    '首行为列名，其中有 length（或 value）；以逗号、分号或制表符分隔',
  'one field for each column; where numbers have decimal commas, semicolons between fields':
    '每列一个字段；数字用逗号作小数点时，字段之间用分号',
  'each run once, or a column such as `evaluations` that says what had been spent by each line':
    '每次运行只出现一次；或有 evaluations 之类的列，说明到该行为止的花费',
  'no less than in the line before of the same run': '不小于同一运行的上一行',
  'a number of at least 0 with a decimal point, or nothing, inf or nan for a run without a path':
    '不小于 0、带小数点的数；没有路径的运行留空，或写 inf 或 nan',
  'a whole number of at least 0, or nothing where it is not known': '不小于 0 的整数，未知时留空',
  'a whole number of at most 9007199254740992, which is 2^53: larger ones are not told apart':
    '不大于 9007199254740992（即 2^53）的整数：更大的数无法区分',
  'at most {} lines': '至多 {} 行',
  'at most {} entries in a file': '一个文件中至多 {} 个参评项',
  'at most {} maps in a file': '一个文件中至多 {} 张地图',
  '"function evaluation" "best-so-far f(x)", or evaluations raw_y':
    '"function evaluation" "best-so-far f(x)"，或 evaluations raw_y',

  // ROS.
  'the name of the picture, e.g. map.pgm': '图片的名称，例如 map.pgm',
  'a number below it': '比它小的数',
  'metres per cell': '每格的米数',
  'metres per cell, above 0': '每格的米数，大于 0',
  'a number of cells': '格数',
  'a whole number of cells, above 0': '整数格，大于 0',
  'trinary, scale or raw': 'trinary、scale 或 raw',
  '[x, y, yaw] of the lower left corner, in metres and radians':
    '左下角的 [x, y, yaw]，以米与弧度计',
  '[column, row] within the dimensions': '范围之内的 [列, 行]',
  'what ros2 topic echo --full-length prints': 'ros2 topic echo --full-length 的输出',
  'one message: ros2 topic echo --once --full-length /plan':
    '一条消息：ros2 topic echo --once --full-length /plan',
  'the whole message: ros2 topic echo --once --full-length /map':
    '完整的消息：ros2 topic echo --once --full-length /map',
  'a number in every column that is named': '每个有名称的列各一个数',
  'a curve as path-csv, path-json, nav-msgs or geojson':
    '以 path-csv、path-json、nav-msgs 或 geojson 写出的曲线',
  "the code of the projected system in which the map's place is said":
    '地图位置所用投影坐标系的代码',
  '[x, y] or [x, y, z] in metres': '以米为单位的 [x, y] 或 [x, y, z]',
  'one number for each cell': '每格一个数',
  'one for each cell': '每格一个',
  '−1, or 0 to 100': '−1，或 0 至 100',
  '`key: value` lines': '每行 key: value',
  'the values themselves': '值本身',

  // Rasters of heights.
  'at least one cell': '至少一格',
  'one number, or `dx N` and `dy N`; heights on lines of their own':
    '一个数，或 dx N 与 dy N；高程另起一行',
  'ncols · nrows = {} numbers': 'ncols · nrows = {} 个数',
  'a decimal point: replace every , by .': '小数点：请把每个“,”换成“.”',
  'cellsize alone, or dx and dy': '只用 cellsize，或用 dx 与 dy',
  'a line `cellsize N`, or `dx N` and `dy N`': '有一行 cellsize N，或 dx N 与 dy N',
  'no more cells than the file can hold': '格数不超过文件所能容纳的',
  '1: rows from above, columns from the left': '1：行由上而下，列由左而右',
  'numbers of 8 to 64 bits, plain or by LZW or deflate':
    '8 至 64 位的数，不压缩，或以 LZW 或 deflate 压缩',
  'black is zero, as heights have it': '0 表示黑色，高程如此',
  'heights, one number a cell': '高程，每格一个数',
  '8, 16, 32 or 64 bits': '8、16、32 或 64 位',
  'projected or geographic ones: gdalwarp': '投影坐标或地理坐标：gdalwarp',
  'metres (9001) or feet (9002, 9003)': '米（9001）或英尺（9002、9003）',
  '3 numbers': '3 个数',
  '16 numbers': '16 个数',
  'another scale': '其他比例',
  'a smaller map': '较小的地图',
  'a latitude between −90° and 90°': '−90° 与 90° 之间的纬度',
  'positive numbers, from 1e-9 to 1e9': '1e-9 至 1e9 的正数',
  'heights from −32767 to 32767 m; write a GeoTIFF': '−32767 至 32767 米的高程；请写成 GeoTIFF',
  '1201 × 1201 or 3601 × 3601 cells; resample, or write a GeoTIFF':
    '1201 × 1201 或 3601 × 3601 格；请重采样，或写成 GeoTIFF',
  '1201 × 1201 or 3601 × 3601 samples of two bytes: 2,884,802 or 25,934,402 bytes':
    '1201 × 1201 或 3601 × 3601 个双字节样本：2,884,802 或 25,934,402 字节',

  // TSPLIB.
  'EXPLICIT, EUC_2D, EUC_3D, MAX_2D, MAX_3D, MAN_2D, MAN_3D, CEIL_2D, GEO or ATT':
    'EXPLICIT、EUC_2D、EUC_3D、MAX_2D、MAX_3D、MAN_2D、MAN_3D、CEIL_2D、GEO 或 ATT',
  'FULL_MATRIX, UPPER_ROW, LOWER_ROW, UPPER_DIAG_ROW, LOWER_DIAG_ROW, UPPER_COL, LOWER_COL, UPPER_DIAG_COL or LOWER_DIAG_COL':
    'FULL_MATRIX、UPPER_ROW、LOWER_ROW、UPPER_DIAG_ROW、LOWER_DIAG_ROW、UPPER_COL、LOWER_COL、UPPER_DIAG_COL 或 LOWER_DIAG_COL',
  'FULL_MATRIX for an ATSP': 'ATSP 用 FULL_MATRIX',
  'EXPLICIT for an ATSP, or TYPE: TSP': 'ATSP 用 EXPLICIT，或 TYPE: TSP',
  'costs of 0 and more': '不小于 0 的代价',
  'equal costs both ways for a TSP, or TYPE: ATSP': 'TSP 的往返代价须相同，或 TYPE: ATSP',
  'costs by coordinates, or in the file, not both': '代价或按坐标，或写在文件中，二者取一',
  'FUNCTION, or EDGE_WEIGHT_TYPE: EXPLICIT': 'FUNCTION，或 EDGE_WEIGHT_TYPE: EXPLICIT',
  '{} numbers for {} of this DIMENSION': '此 DIMENSION 的 {1} 需要 {0} 个数',
  'an instance; name a tour beside it, with --tour on the command line':
    '实例；巡回请与它一起给出，命令行用 --tour',
  'nothing behind the type, or a remark in parentheses': '类型之后没有内容，或括号中的备注',
  'KEY: value, or a section': 'KEY: value，或一节数据',
  'every section once': '每节只出现一次',
  'every key once': '每个关键字只出现一次',
  'all keys before the data': '所有关键字都在数据之前',
  'TSP or ATSP, in capitals': '大写的 TSP 或 ATSP',
  'nothing there': '此处没有内容',
  'no sections but {}': '只有这些节：{}',
  'a TSP or ATSP without it': '没有它的 TSP 或 ATSP',
  'a number, a section, or one of {} in capitals with a colon':
    '一个数、一节数据，或大写并带冒号的 {} 之一',
  'TWOD_COORDS, THREED_COORDS or NO_COORDS': 'TWOD_COORDS、THREED_COORDS 或 NO_COORDS',
  'COORD_DISPLAY, TWOD_DISPLAY or NO_DISPLAY': 'COORD_DISPLAY、TWOD_DISPLAY 或 NO_DISPLAY',
  'as many coordinates as distances are of': '坐标数与距离的维数相同',
  'latitude to 90 and longitude to 360, as DDD.MM': '纬度不超过 90，经度不超过 360，写作 DDD.MM',
  'a number from 1 to {} (DIMENSION)': '1 至 {}（DIMENSION）的数',
  'one run a line, in the order of the tasks': '每行一次运行，按任务的顺序',
  'a session as the page saves it': '网页保存的会话',
  'a session as the page saves it; docs/formats.md has its fields':
    '网页保存的会话；各字段见 docs/formats.md',
  'the whole address, as the share dialog copies it': '分享对话框复制的完整地址',
  "an address with `{}`, as the page's share dialog makes it": '分享对话框给出的带“{}”的地址',
  'every place once': '每个地点恰好一次',
  'number, x, y': '编号、x、y',
  'number, x, y, z': '编号、x、y、z',
  'TYPE: TOUR, as tours of the library have it': 'TYPE: TOUR，与库中的巡回相同',
  '{}, as the problem has places': '{}，即问题的地点数',
  'one tour in a file': '每个文件一条巡回',
  'numbers from 1 to {}, then -1': '1 至 {} 的数，然后是 -1',
}
