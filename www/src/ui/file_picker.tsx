/** The browser's own choice of files behind a control of ours. */
import { useRef } from 'preact/hooks'

interface FilePickerProps {
  /** For screen readers. */
  label: string
  /** Endings that are offered first, with commas. */
  accept: string
  multiple?: boolean
  testId: string
  onFiles: (files: File[]) => void
}

/** What opens the choice, and the element to put on the page. The same file may be chosen twice. */
export function useFilePicker(props: FilePickerProps) {
  const input = useRef<HTMLInputElement>(null)
  const element = (
    <input
      ref={input}
      type="file"
      multiple={props.multiple}
      class="visually-hidden"
      tabIndex={-1}
      aria-label={props.label}
      accept={props.accept}
      data-testid={props.testId}
      onChange={(event) => {
        const files = [...(event.currentTarget.files ?? [])]
        event.currentTarget.value = ''
        props.onFiles(files)
      }}
    />
  )
  return { pick: () => input.current?.click(), element }
}
