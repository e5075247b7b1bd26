let isLeft = false;

/** Whether the page is being left: then a question to the storage may never be answered. */
export function isLeaving(): boolean {
  return isLeft;
}

// Before anybody else hears of it, and saves what was typed last.
addEventListener(
  'pagehide',
  () => {
    isLeft = true;
  },
  true,
);
addEventListener(
  'pageshow',
  () => {
    isLeft = false;
  },
  true,
);
