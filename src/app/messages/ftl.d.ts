declare module '*.ftl?first' {
  const tree: { readonly first: import('./sentences.js').FirstSentences['first'] };
  // biome-ignore lint/style/noDefaultExport: the form of a file that is no script
  export default tree;
}
declare module '*.ftl?page' {
  const tree: import('./catalogue.js').Tree;
  // biome-ignore lint/style/noDefaultExport: the form of a file that is no script
  export default tree;
}
declare module '*.ftl?more' {
  const tree: import('./catalogue.js').Tree;
  // biome-ignore lint/style/noDefaultExport: the form of a file that is no script
  export default tree;
}
