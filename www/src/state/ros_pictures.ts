/** Pictures that belong to the description of a ROS map. */
import { lateTools } from '../engine/late_tools'
import { tools } from '../engine/tools'
import { fileName, folderOf, sameName } from './file_paths'
import { type FoundFile, mapFile, type NamedBytes } from './offered_files'

/** Pictures that descriptions among the files name: they are no maps of their own. */
export async function picturesNamed(files: FoundFile[]): Promise<Set<FoundFile>> {
  const named = new Set<FoundFile>()
  for (const file of files) {
    if (file.kind !== 'ros-map') continue
    const image = pictureOf(file, await nameOfPicture(file), files)
    if (image) named.add(image)
  }
  return named
}

/** Empty where the description is broken: its import says how. */
export const nameOfPicture = (file: NamedBytes) => lateTools.rosImage(file.bytes).catch(() => '')

/** Of several of the same name, the one in the folder of the description. */
export function pictureOf(
  map: FoundFile,
  image: string,
  files: FoundFile[],
): FoundFile | undefined {
  const alike = files.filter(({ name, kind }) => kind === 'picture' && sameName(name, image))
  return alike.find(({ name }) => folderOf(name) === folderOf(map.name)) ?? alike[0]
}

/** Gives the description that waits its picture, if it came: by its name, or a single picture. Null: none did. */
export async function takePicture(given: NamedBytes[]): Promise<NamedBytes | null> {
  const waiting = mapFile.peek()
  const needs = waiting?.needs
  if (!waiting || !needs) return null
  const image =
    given.find(({ name }) => sameName(name, needs)) ??
    (given.length === 1 && given[0] && (await isPicture(given[0])) ? given[0] : null)
  if (!image || mapFile.peek() !== waiting) return null
  const { name, bytes } = image
  mapFile.value = { ...waiting, image: { name: fileName(name), bytes }, needs: null }
  return image
}

const isPicture = async ({ bytes, name }: NamedBytes) =>
  (await tools.recognise(bytes, name)).kind === 'picture'
