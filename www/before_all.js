// Before all else, and in words that old browsers know: the theme, whether this browser can run the page, and what begins then.
// Stands in the page itself: before_all.ts puts the addresses of its scripts where `scripts` gets its value. The page in one file has none
// (null): its loader goes on where nothing is missing, and it reads nothing that a browser keeps.
;(function () {
  var LEAST = 'Chrome / Edge 110, Firefox 115, Safari 16.4'
  var inChinese = /^zh/i.test(navigator.language)

  function words(english, chinese) {
    return inChinese ? chinese : english
  }

  // The theme must stand before the first paint, or dark pages flash white; state/appearance.ts takes over.
  function setTheme() {
    var query = new URLSearchParams(location.search)
    var chosen = null
    try {
      chosen = query.has('embed') ? query.get('theme') : localStorage.getItem('formicarium.theme')
    } catch (error) {}
    var dark = window.matchMedia && matchMedia('(prefers-color-scheme: dark)').matches
    document.documentElement.setAttribute('data-theme', chosen || (dark ? 'dark' : 'light'))
  }

  // A function of 128 bits: the engine computes with such numbers.
  var SIMD = [
    0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11,
  ]

  function hasModuleWorkers() {
    var asked = false
    try {
      // No address: it is refused, after its options have been read.
      new Worker('http://[', {
        get type() {
          asked = true
          return 'module'
        },
      })
    } catch (error) {}
    return asked
  }

  function missing() {
    var canvas = window.HTMLCanvasElement && HTMLCanvasElement.prototype
    var all = [
      [window.WebAssembly && WebAssembly.validate(new Uint8Array(SIMD)), 'WebAssembly SIMD'],
      [window.OffscreenCanvas && canvas.transferControlToOffscreen, 'OffscreenCanvas'],
      [window.CompressionStream && window.DecompressionStream, 'CompressionStream'],
      [hasModuleWorkers(), words('module workers', '模块 Worker')],
      [Array.prototype.toSorted && window.structuredClone, 'ECMAScript 2023'],
    ]
    var names = []
    for (var i = 0; i < all.length; i++) if (!all[i][0]) names.push(all[i][1])
    return names
  }

  function say(title, text, address) {
    function write() {
      var main = document.createElement('main')
      main.className = 'empty'
      main.setAttribute('data-testid', 'cannot-start')
      main.setAttribute('role', 'alert')
      main.appendChild(document.createElement('h1')).textContent = title
      main.appendChild(document.createElement('p')).textContent = text
      if (address) {
        var link = main.appendChild(document.createElement('p')).appendChild(document.createElement('a'))
        link.href = address
        link.textContent = words('Try again', '重试')
      }
      var place = document.getElementById('app')
      place.textContent = ''
      place.appendChild(main)
    }
    if (document.getElementById('app')) write()
    else document.addEventListener('DOMContentLoaded', write)
  }

  function sayMissing(names) {
    say(
      words('This browser cannot run Formicarium', '此浏览器无法运行 Formicarium'),
      words('It lacks ' + names.join(', ') + '. These can: ' + LEAST + ', and later ones.', '它缺少' + names.join('、') + '。可用的浏览器：' + LEAST + ' 及更新版本。'),
    )
  }

  function sayUnfetched() {
    // Should a copy of the page be at fault, the next try asks the network.
    try {
      navigator.serviceWorker.getRegistration().then(function (kept) {
        if (kept) kept.unregister()
      })
    } catch (error) {
      // A sandbox has none, and refuses to be asked.
    }
    say(
      words('The page could not be fetched', '无法获取页面'),
      words('Check the connection and try again. If that does not help, the page has been moved or is being renewed.', '请检查网络连接后重试。如果仍然不行，页面可能已移动或正在更新。'),
      location.href,
    )
  }

  function begin(scripts) {
    for (var i = 0; i < scripts.length; i++) {
      var first = i === 0
      var element = document.createElement(first ? 'script' : 'link')
      if (first) {
        element.type = 'module'
        element.onerror = sayUnfetched
      } else element.rel = 'modulepreload'
      element.crossOrigin = ''
      element[first ? 'src' : 'href'] = scripts[i]
      document.head.appendChild(element)
    }
  }

  var names = missing()
  var scripts = SCRIPTS
  if (scripts) setTheme()
  if (names.length > 0) {
    document.documentElement.setAttribute('data-lacks', names.join(', '))
    sayMissing(names)
  } else if (!scripts) return
  else if (scripts.length > 0 && /one-file\.html$/.test(location.pathname)) sayUnfetched()
  else if (scripts.length > 0 && (location.protocol === 'file:' || self.origin === 'null')) {
    // Browsers give such a page none of its scripts: the one-file page brings its own.
    var address = './one-file.html' + location.search + location.hash
    say(
      words('Opening the page in one file…', '正在打开单文件页面…'),
      words('Opened as a file, or in a sandbox, the page cannot fetch its parts. The file one-file.html beside it holds all of it.', '以文件方式或在沙盒中打开时，页面无法获取其各部分；旁边的 one-file.html 包含全部内容。'),
      address,
    )
    location.replace(address)
  } else begin(scripts)
})()
