/** Whether what is on show was sent to the reader, and they have not been told yet what that is. */
import { signal } from '@preact/signals'
import { returnedTo } from './address'

/** True from when a link of the address was opened until its offer is taken or hidden. */
export const received = signal(false)

/** A link of the address has been opened. Who comes back to it knows it. */
export function tellReceived(): void {
  received.value = location.hash !== returnedTo
}
