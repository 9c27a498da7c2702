/** What the engine says of files, maps and runs: its notices and errors. */
export const zhCNRemarks = {
  notices: {
    'drawn-flaw': '{{message}}',
    unreachable: '在此移动规则下，起点与终点之间没有通路。',
    'start-is-goal': '起点与终点是同一格：路径长度为 0。',
    'results-columns': '未使用的列：{{columns}}。',
    'results-improvements': '{{runs}} 次运行的 {{lines}} 行按“每行一次改进”读入。',
    'results-status': '未知的结束方式，已忽略：{{words}}。',
    'results-incomplete': '{{records}} 条字段不足的记录已略去。',
    'ends-chosen': '文件没有给出起点和终点：使用 ({{start}}) 与 ({{goal}})。',
    'matrix-one-is-blocked':
      '0 读作空闲，1 读作障碍。若含义相反，请在地图菜单中选择“交换墙与空地”。',
    'read-as': '文件没有明说格式，按推断读取。',
    archive: '从压缩包中读取了“{{name}}”。',
    'matrix-chosen': '读取了 {{count}} 个矩阵中的第 {{number}} 个。',
    'matrix-repeated': '文件中同样的数字出现了 {{count}} 次，只读取一次。',
    'matrix-columns-joined': '分成几块打印的列已并排合并。',
    'matrix-ends': '2 读作起点，3 读作终点。',
    'matrix-labels': '$t(labels.{{which}})读作标签，不是格子。',
    'matrix-other-numbers': '{{count}} 格为 {{value}}：读作障碍。',
    'matrix-rest-ignored': '只读取了第 {{line}} 行起的 {{count}} 行数字，其余文字已忽略。',
    'matrix-size-line': '到第 {{line}} 行为止的数字读作尺寸 {{width}} × {{height}}，不是格子。',
    'matrix-stated-ends': '起点与终点 {{pairs}}：$t(orders.{{order}})。',
    'drawing-letters': '{{walls}} 读作障碍，{{free}} 读作空闲。',
    'drawing-ends': '{{ends}} 读作路径的端点。',
    'drawing-padded': '较短的行末补了 {{count}} 个空格，作为空闲格。',
    'picture-of-ros':
      '灰度 0、205、254 是 ROS 地图所用的：请与其 .yaml 一起打开；单独打开时，{{unknown}} 个灰度为 205（未知）的像素按阈值判断。',
    'matrix-computed': '程序还对它做了运算（“{{sign}}”）：这里按原样读取。',
    'matrix-decimal-commas': '数字中的逗号按小数点读取。',
    'picture-threshold': '比 {{threshold}} 暗的像素为墙：{{cells}} 格中有 {{blocked}} 格为障碍。',
    'picture-threshold-light':
      '灰度不低于 {{threshold}} 的像素为墙：{{cells}} 格中有 {{blocked}} 格为障碍。',
    'picture-threshold-chosen': '灰度 {{threshold}} 最能区分深色与浅色（大津法）。',
    'picture-shrunk':
      '{{width}} × {{height}} 像素合为 {{columns}} × {{rows}} 格：其中任一像素为墙，该格即为障碍。',
    'picture-transparent': '{{count}} 个透明像素按白色背景处理。',
    'picture-turned': '文件注明相机被旋转过：未予旋转，像素按原样读取。',
    'picture-first-only': '文件中有多张图片：读取了第一张。',
    'ros-cells':
      '{{free}} 格空闲，{{occupied}} 格占据，{{unknown}} 格未知：未知格视为$t(states.{{as}})。',
    'ros-no-threshold': '文件没有 {{key}}：采用 map_saver 的常用值 {{value}}。',
    'ros-205':
      '{{count}} 格的灰度为 205，即 map_saver 所写的未知；按文件的 free_thresh {{free}}，它们是空闲；若为 0.196，则是未知。',
    'ros-205-alpha':
      '{{count}} 格的灰度为 205，即 map_saver 所写的未知；nav2 把透明度通道算作第四种颜色，因此它们成为空闲；请把图片另存为不带透明度的格式。',
    'path-unplaced': '地图在世界中的位置未知：左下角取为 (0, 0)，与 convert 写出的 ROS 地图一致。',
    'path-map-unplaced': '地图在世界中的位置未知：路径的米制坐标从左下角算起。',
    'path-curve': '路径以平滑曲线写出，单位为米。',
    'path-tight': '曲线的曲率超过每米 {{bound}}：没有更宽的转弯可走。',
    'path-no-curve': '没有可走的平滑曲线：路径按规划结果写出。',
    'path-frame': '路径的坐标系是 {{path}}，地图的是 {{map}}：二者的米制坐标按相同处理。',
    'path-frame-unnamed': '路径的坐标系是 {{path}}，地图没有说明坐标系：二者的米制坐标按相同处理。',
    'path-moved': '各位置已移到所在格的中心，按逐格的步计算：check 按路径本来的样子衡量。',
    'path-joined': '有 {{count}} 处相邻位置相距超过一步，已用其间的格子连接：长度按这些步计算。',
    'path-polyline-joined': '折线的 {{count}} 段已用其间的格子连接：长度按这些步计算。',
    'geojson-crs':
      '坐标属于 EPSG:{{code}}，由 GeoJSON 2008 的成员 crs 给出：RFC 7946 只有 WGS 84 的度数，不读 crs 的程序会把线放错位置。',
    'ros-first-message': '文件中有多条消息：读取了第一条。',
    'cells-shrunk':
      '{{width}} × {{height}} 格合为 {{columns}} × {{rows}} 格：每 {{by}} × {{by}} 格取其中最受阻的一格。',
    mapf: '多智能体路径规划实例，共 {{count}} 个智能体：只采用第一个的起点与终点；此处 y 向下。',
    'map-corners': '{{columns}} × {{rows}} 个角点的高度已略去：只读取其间的格子。',
    'map-stations': '{{emitters}} 个发射器（E）与 {{stations}} 个站点（S）读作空闲。',
    swamp: '{{count}} 格沼泽（S）读作空闲；若给出沼泽的系数，通过它的代价会更高。',
    'swamp-factor': '{{count}} 格沼泽（S）的系数为 {{factor}}。',
    water: '{{count}} 格水面（W）读作障碍：从地面不能进入。',
    'costs-read': '{{count}} 格有代价：按规则 {{rule}}，其系数最大为 {{most}}。',
    'costs-none': '文件中没有代价：每个空闲格的代价就是其长度。',
    'costs-unread':
      '{{count}} 格的值在 1 至 99 之间，按阈值判断；若这是代价地图，这些值就是代价：请选择按代价读取。',
    'nav2-defaults': '采用 Nav2 的默认值：{{what}}。',
    'scen-version': '首行没有版本号：按版本 1 读取。',
    'scen-unlisted': '{{count}} 个场景的起点与终点不同而最优长度为 0：视为未知。',
    'scen-size': '第 {{line}} 行：所属地图为 {{size}} 格。',
    'results-no-path': '文件中没有一次运行有路径：长度均为空。',
    'results-coco': 'COCO 的数据文件：与最优值之差按长度读取。',
    'figure-cells': '{{cells}} 格中有 {{walls}} 格为墙，{{unsure}} 格需要核对。',
    'figure-lattice':
      '找到 {{columns}} × {{rows}} 格的网格；在命令行中写作 --lattice {{lattice}}。',
    'figure-unsure-blocked': '{{unsure}} 个存疑的格视为墙。',
    'figure-no-ends': '没有找到以独特颜色标出的起点与终点。',
    'figure-ends-guessed': '哪个标记是起点、哪个是终点只是推测：都不是绿色或红色。',
    'terrain-feet': '按文件所说，高程以英尺（{{unit}} 米）计。',
    'terrain-scaled': '按文件所说，高程为其数字乘以 {{scale}} 再加 {{offset}}。',
    'terrain-words': '{{count}} 格以 nan、null 等词代替高程：没有数据。',
    'terrain-impossible':
      '{{count}} 格的高程不可能存在（如 {{value}}）：超出海平面上下 {{most}} 米者视为没有数据。',
    'terrain-no-data-unused':
      '文件称 {{value}} 表示没有数据，但其数字为 {{low}} 至 {{high}} 的整数：没有这样的格。',
    'terrain-9999':
      '{{count}} 格的高程为 −9999，许多程序以此表示没有数据；但文件没有这样说明，因此按地面读取。',
    'terrain-south-up': '文件的行由南向北排列：已上下翻转，北方在上。',
    'map-type': '地图类型为“{{value}}”，按 octile 读取。',
    'heights-in-table': '数字读作高程（米）：地图只含 0 和 1。',
    'terrain-cell-size': '文件没有给出格子的大小：按 1 米计，可在“尺寸、移动与地形…”中更改。',
    'terrain-no-data': '{{count}} 格没有数据，作为障碍。',
    'terrain-geographic': '格子以度计：在纬度 {{latitude}}° 处宽 {{x}} 米、高 {{y}} 米。',
    'terrain-no-latitude': '文件名没有给出纬度（如 N40W106.hgt）：格子按赤道处的大小计。',
    'terrain-cells-not-square':
      '格子宽 {{x}} 米、高 {{y}} 米，按边长 {{mean}} 米的正方形计；取 {{columns}} × {{rows}} 格时为正方形。',
    'terrain-shrunk':
      '{{width}} × {{height}} 格超出地图的大小：每 {{by}} 格合为一格，共 {{columns}} × {{rows}} 格；裁剪可保留全部。',
  },
  /** Parts of remarks. */
  labels: { both: '首行与首列', row: '首行', column: '首列' },
  orders: {
    columns: '按列、行读取',
    rows: '按行、列读取，因为反过来不是空闲格',
    unsure: '可能是列、行，也可能是行、列，因此未采用',
    nowhere: '不是空闲格，因此未采用',
  },
  states: { blocked: '障碍', free: '空闲' },
  /** By what a file was recognised. */
  whys: {
    'its-first-bytes': '开头的字节',
    'the-header-of-a-map': '.map 的文件头',
    'the-names-of-its-columns': '列名',
    'the-keys-of-its-header': '文件头的关键字',
    'the-keys-image-resolution-and-origin': '关键字 image、resolution 与 origin',
    'the-keys-info-and-data': '关键字 info 与 data',
    'the-keys-map-and-agents': '关键字 map 与 agents',
    'places-in-brackets-or-poses': '括号中的位置或 poses',
    'its-version-line': '版本行',
    'its-name-and-the-fields-of-its-first-line': '文件名与首行的字段',
    'rows-of-numbers': '成行的数字',
    'a-bracket-of-numbers': '括号中的数字',
    'rows-of-and': '由 # 与 . 组成的行',
    'rows-of-and-or-blanks': '由 # 与 . 或空格组成的行',
    'its-field-format': '字段 format',
    'its-size': '文件大小',
    'its-name': '文件名',
  },
  /** What a file turned out to be, and what to do with it. */
  found: {
    'an-instance-of-tsplib': { name: 'TSPLIB 实例', hint: '请把 .tsp 文件单独拖入' },
    'a-tour-of-tsplib': { name: 'TSPLIB 巡回', hint: '请与所属的 .tsp 实例一起打开' },
    'a-vehicle-routing-problem-cvrp-of-tsplib': {
      name: 'TSPLIB 的车辆路径问题（CVRP）',
      hint: '只能读取单一巡回的问题：TYPE 为 TSP 或 ATSP',
    },
    'a-sequential-ordering-problem-sop-of-tsplib': {
      name: 'TSPLIB 的顺序排列问题（SOP）',
      hint: '只能读取单一巡回的问题：TYPE 为 TSP 或 ATSP',
    },
    'a-hamiltonian-cycle-problem-hcp-of-tsplib': {
      name: 'TSPLIB 的哈密顿回路问题（HCP）',
      hint: '只能读取单一巡回的问题：TYPE 为 TSP 或 ATSP',
    },
    'an-instance-of-tsplib-with-keys-in-small-letters': {
      name: '关键字为小写的 TSPLIB 实例',
      hint: '请把关键字改为大写：DIMENSION、EDGE_WEIGHT_TYPE 等',
    },
    'an-ascii-grid-of-grass': {
      name: 'GRASS 的 ASCII 栅格',
      hint: '请用 r.out.gdal 写成 GeoTIFF，或以 format=AAIGrid 写成 ESRI ASCII',
    },
    'the-list-of-the-data-files-of-coco-or-iohprofiler-info-': {
      name: 'COCO 或 IOHprofiler 的数据文件清单（.info）',
      hint: '请打开其中所列的 .dat 文件',
    },
    'the-list-of-the-data-files-of-iohprofiler-json-': {
      name: 'IOHprofiler 的数据文件清单（.json）',
      hint: '请打开其中所列的 .dat 文件',
    },
    'json-of-another-program': {
      name: '其他程序的 JSON',
      hint: '请把地图写成矩阵 [[0, 1], …]，或 formicarium/scenario@1',
    },
    'an-array-of-true-and-false': {
      name: '由真与假组成的数组',
      hint: '请写成 0 和 1：a.astype(int)',
    },
    'a-picture-in-pam-p7-': { name: 'PAM 图片（P7）', hint: '请另存为 PNG 或 PGM，再作为图片打开' },
    'a-picture-of-floats-pfm-': {
      name: '浮点图片（PFM）',
      hint: '请把高程写成 GeoTIFF，或另存为 PNG',
    },
    'a-grid-of-surfer-dsaa-': {
      name: 'Surfer 栅格（DSAA）',
      hint: '请写成 GeoTIFF：gdal_translate in.grd out.tif',
    },
    'a-gif-image': { name: 'GIF 图像', hint: '请另存为 PNG，再作为图片打开' },
    'a-pdf-document': { name: 'PDF 文档', hint: '请截取其中的图，再打开截图' },
    'a-numpy-array-npy-': {
      name: 'NumPy 数组（.npy）',
      hint: '请写成文本：np.savetxt("map.csv", a, fmt="%d", delimiter=",")',
    },
    'a-pickle-of-python': {
      name: 'Python 的 pickle 文件',
      hint: '请写成文本：np.savetxt("map.csv", a, fmt="%d", delimiter=",")',
    },
    'a-binary-matlab-mat-file': {
      name: 'MATLAB 的二进制 .mat 文件',
      hint: '请在 MATLAB 中写成文本：writematrix(G, "map.csv")',
    },
    'an-hdf5-file-a-mat-of-matlab-7-3-perhaps-': {
      name: 'HDF5 文件（可能是 MATLAB 7.3 的 .mat）',
      hint: '请在 MATLAB 中写成文本：writematrix(G, "map.csv")',
    },
    'a-netcdf-file': {
      name: 'NetCDF 文件',
      hint: '请把高程写成 GeoTIFF：gdal_translate in.nc out.tif',
    },
    'a-7-zip-archive': { name: '7-Zip 压缩包', hint: '请解压后打开其中的文件' },
    'a-rar-archive': { name: 'RAR 压缩包', hint: '请解压后打开其中的文件' },
    'a-tar-archive': { name: 'tar 归档', hint: '请解开后打开其中的文件' },
    'text-in-utf-16': { name: 'UTF-16 文本', hint: '请另存为 UTF-8' },
    'a-page-of-the-web': { name: '网页', hint: '请下载文件本身：在 GitHub 上选择 Raw' },
    'a-drawing-in-svg': { name: 'SVG 图形', hint: '请另存为 PNG，再作为图片打开' },
  },
  errors: {
    'foreign-file': { message: '这是{{found}}，此处不能读取', hint: '请另存为可打开的格式' },
    'needs-file': { message: '这只是地图的一半，还需要“{{other}}”', hint: '请把两个文件一起打开' },
    'ambiguous-file': {
      message: '该文件可能有两种含义：{{found}}',
      hint: '请把所需的部分单独存为一个文件',
    },
    'several-matrices': {
      message: '文件中有多个矩阵',
      hint: '请用“导入…”打开该文件并选择其中一个',
    },
    'not-a-map': { message: '该文件不是地图', hint: '请打开所属的地图' },
    syntax: { message: '第 {{line}} 行：{{what}}', hint: '应为：{{expected}}' },
    'no-path': {
      message: '.scen 需要长度，而在不切角的规则下起点与终点之间没有通路',
      hint: '请打通一条路，或以 JSON 导出场景',
    },
    'out-of-range': {
      message: '{{field}} = {{value}} 超出范围 {{min}} 至 {{max}}',
      hint: '请选择 {{min}} 与 {{max}} 之间的值',
    },
    'wrong-type': { message: '{{field}} 的值 {{value}} 类型不对', hint: '请改正该值' },
    'unknown-planner': { message: '没有规划器“{{value}}”', hint: '可用的有 {{known}}' },
    'start-blocked': {
      message: '起点 ({{x}}, {{y}}) 位于障碍上',
      hint: '移动起点，或清除该处的墙',
    },
    'goal-blocked': { message: '终点 ({{x}}, {{y}}) 位于障碍上', hint: '移动终点，或清除该处的墙' },
    'outside-map': {
      message: '({{x}}, {{y}}) 在地图之外',
      hint: '列与行都从 0 开始计数；请选择地图内的格子',
    },
    'too-many-goals': {
      message: '该规划器最多到达 {{max}} 个目标，地图上有 {{value}} 个',
      hint: '删除一些目标，或选择能访问多个目标的规划器',
    },
    ground: {
      message: '该规划器不能{{ground}}规划',
      hint: '请选择其他规划器，或在地图菜单中更改移动方式',
    },
    'value-on-ground': {
      message: '{{field}} = {{value}} 时，该规划器不适用于这张地图的移动方式或多个目标',
      hint: '请设 {{field}} = {{instead}}，或更改移动方式与目标',
    },
    'heights-missing': { message: '地形没有高程', hint: '请重新打开地形' },
    'terrain-missing': { message: '有高程，但没有说明如何移动', hint: '请重新打开地形' },
    factor: {
      message: '格 ({{x}}, {{y}}) 的系数 {{value}} 不能使用',
      hint: '普通地面为 1，代价更高的地面至多 {{max}}；不能进入的格请设为障碍',
    },
    'weighted-terrain': {
      message: '有高程的地图不能有格子的系数，也不能有障碍物附近的代价',
      hint: '请去掉高程，或去掉系数与障碍物附近的代价',
    },
    'start-too-narrow': {
      message: '机器人在起点 ({{x}}, {{y}}) 放不下：障碍物不超过其半径 {{radius}} 米',
      hint: '请移到离障碍物更远处，或减小半径',
    },
    'goal-too-narrow': {
      message: '机器人在终点 ({{x}}, {{y}}) 放不下：障碍物不超过其半径 {{radius}} 米',
      hint: '请移到离障碍物更远处，或减小半径',
    },
    'start-below-ground': {
      message: '起点位于第 {{level}} 层，在地面之下',
      hint: '该处最低为第 {{lowest}} 层',
    },
    'goal-below-ground': {
      message: '终点位于第 {{level}} 层，在地面之下',
      hint: '该处最低为第 {{lowest}} 层',
    },
    'drawn-outside': {
      message: '({{x}}, {{y}}) 在地图之外',
      hint: '请留在地图的行列之内',
    },
    'drawn-blocked': {
      message: '({{x}}, {{y}}) 是障碍',
      hint: '请绕开墙，或撤销最后一段',
    },
    'drawn-no-way': {
      message: '从 ({{x}}, {{y}}) 没有允许的一步能更接近 ({{to_x}}, {{to_y}})',
      hint: '请逐格绕过障碍：移动规则可能不允许切角',
    },
    'drawn-slices': {
      message: '分层路径不能手绘',
      hint: '请沿地表移动，或在没有高程的地图上绘制',
    },
    'goal-count': { message: '不能使用 {{value}} 个目标', hint: '请设置 1 到 {{max}} 个目标' },
    'goal-twice': {
      message: '有两个目标位于 ({{x}}, {{y}})',
      hint: '移动或删除其中一个',
    },
    'goal-on-start': { message: '起点位于 ({{x}}, {{y}})', hint: '请选择另一格' },
    'start-on-goal': { message: '目标位于 ({{x}}, {{y}})', hint: '请选择另一格' },
    'place-in-metres': {
      message: '“{{value}}”不是位置',
      hint: '请写列与行，例如 11, 4，或米，例如 2m, 0.5m',
    },
    place: { message: '“{{value}}”不是位置', hint: '请写列与行，例如 11, 4' },
    quantity: {
      message: '不能使用 {{field}} = {{value}}',
      hint: '请输入不过大的数：长度、速度与权重须为正；用时、半径、倍数、能耗系数与曲率也可以是 0',
    },
    change: {
      message: '不能按 {{field}} = {{value}} 改动墙体',
      hint: '请检查格子与迭代次数',
    },
    // What is allowed depends on the field: fields.ts has it.
    drive: { message: '行驶时不能使用 {{field}} = {{value}}' },
    memory: {
      message: '需要 {{megabytes}} MB 内存，超过可用的 {{max}} MB',
      hint: '请减少数量，或裁剪、缩小地图',
    },
    'map-too-large': {
      message: '此规划器不能用于 {{width}} × {{height}} 格的地图',
      hint: '请改用 {{instead}}，或裁剪、缩小地图',
    },
    'map-size': {
      message: '不能使用 {{width}} × {{height}} 格的地图',
      hint: '每边 1 到 {{max}} 格',
    },
    'unknown-format': {
      message: '无法识别该文件的格式',
      hint: '可打开 MovingAI .map 与 .scen、0/1 矩阵、高程（ESRI ASCII、CSV、GeoTIFF、SRTM），以及 JSON 场景',
    },
    'not-a-terrain': { message: '该文件不含高程', hint: '请作为地图打开' },
    'no-heights': {
      message: '地形中没有任何高程',
      hint: '所有格都是无数据值，或所选窗口内没有数据',
    },
    'bad-field': { message: '文件的 {{field}} 不能使用：{{what}}', hint: '应为：{{expected}}' },
    'bad-cell': {
      message: '第 {{line}} 行“{{column}}”列：“{{value}}”不能使用',
      hint: '应为：{{expected}}',
    },
    window: {
      message: '({{x}}, {{y}}) 处 {{columns}} × {{rows}} 格的窗口超出 {{width}} × {{height}} 格',
      hint: '请选择范围之内的窗口',
    },
    'not-text': { message: '该文件不是 UTF-8 文本', hint: '请选择文本格式的地图文件' },
    'no-free-cell': {
      message: '地图没有空闲格',
      hint: '至少清除一格；若 1 表示空闲，请先反转地图',
    },
    'too-large': { message: '{{what}}超出可读取的上限（{{max}}）', hint: '请先裁剪或缩小地图' },
    version: {
      message: '格式版本为“{{value}}”，此版本读取“{{expected}}”',
      hint: '请刷新页面后重试',
    },
    'link-foreign': {
      message: '这不是 Formicarium 的分享链接',
      hint: '分享链接的地址后以 #x= 或 #q= 开头；请复制完整链接',
    },
    'link-damaged': {
      message: '链接已损坏',
      hint: '可能缺少一部分；请重新复制完整链接，或索取文件',
    },
    'link-cut': {
      message: '链接已损坏：共 {{all}} 个字符，缺少 {{missing}} 个',
      hint: '发送途中有程序将其去掉，多在末尾；请重新复制完整链接，或索取文件',
    },
    'link-changed': {
      message: '链接已损坏：与生成时不同',
      hint: '发送途中有程序改动了其中的字符；请对方换一种方式发送，或索取文件',
    },
    'link-newer': { message: '链接由更新的版本生成', hint: '请刷新页面获取最新版本后再打开' },
    'link-too-large': {
      message: '链接的内容太大',
      hint: '可打开不超过 4096 × 4096 格、六个面板的内容',
    },
    'link-invalid': {
      message: '链接内容无效：{{field}}',
      hint: '它不是由“分享”生成，或被手工改动过',
    },
    'link-share': {
      message: '没有“{{field}}”这一份',
      hint: '份写作 I/N（例如 3/30）或 ?/30；请向发送链接的人另要一个',
    },
    'picture-bare': {
      message: '图片中没有会话，也没有比较',
      hint: '此处保存的图片带有会话或比较，但有些程序重新保存时会将其去掉；请索取原图、链接或文件',
    },
    'part-unreachable': {
      message: '无法获取页面的这一部分{{reason}}',
      hint: '请检查网络连接后重试；页面上的内容没有丢失',
    },
    'page-outdated': {
      message: '页面已更新为新版本，旧版本的这一部分已不存在',
      hint: '重新加载即可更新。地图、规划器及其参数都会保留，运行将重新开始',
    },
    'engine-crashed': { message: '引擎已停止', hint: '绘制的内容没有丢失；重置即可重新启动引擎' },
  },
}
