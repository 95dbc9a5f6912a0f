declare module "*.py" {
  const text: string;
  export default text;
}

/** What the build puts in: the head of Pyodide's list of packages, none of which is loaded. */
declare const LOCK: string;
/** The files that the page works with when there is no network, and a name for just these. */
declare const FILES: string[];
declare const VERSION: string;
