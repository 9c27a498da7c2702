/** Names of files that came with the path of their folder or archive. */

const folderEnds = (path: string) => [path.lastIndexOf('/'), path.lastIndexOf('\\')]

export const fileName = (path: string) => path.slice(Math.max(...folderEnds(path)) + 1)
/** Up to the first dot, in lower case. */
export const stemOf = (path: string) => fileName(path).toLowerCase().split('.')[0]
export const folderOf = (path: string) => path.slice(0, Math.max(0, ...folderEnds(path)))
export const sameName = (a: string, b: string) =>
  fileName(a).toLowerCase() === fileName(b).toLowerCase()
