// What an error says to developers is prose: a string of several words, and nobody tests them. What names a place or a
// figure is a template, and is changed like all else.

const prose = {
  shouldIgnore(path) {
    return path.isStringLiteral() && /^\w.* \w/.test(path.node.value) ? 'prose' : undefined;
  },
};

export const strykerPlugins = [{ kind: 'Ignore', name: 'prose', value: prose }];
