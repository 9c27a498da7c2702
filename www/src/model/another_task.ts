/** Lets the browser do what waits: what would be one long task becomes two. */
export const anotherTask = () => new Promise<void>((resolve) => setTimeout(resolve))
