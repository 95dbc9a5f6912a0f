declare module "*.py" {
  const text: string;
  export default text;
}

/** What the build puts in: the head of Pyodide's list of packages, none of which is loaded. */
declare const LOCK: string;
/** A name for all that a Python which has loaded everything holds in memory. */
declare const MEMORY: string;
/** The files that the page works with when there is no network, and a name for just these. */
declare const FILES: string[];
declare const VERSION: string;
