/**
 * A reader of RFC 4180 that shares nothing with the writer: a state for each character. It takes rows of equal length
 * alone, ended by CR LF.
 */
export function readCsv(text: string, separator: string): string[][] {
  const rows: string[][] = [];
  let [row, cell, state]: [string[], string, 'start' | 'plain' | 'quoted' | 'quote' | 'cr'] = [[], '', 'start'];
  const endCell = (): void => {
    row.push(cell);
    cell = '';
  };
  for (const character of text) {
    if (state === 'cr') {
      if (character !== '\n') throw new Error('a CR has no LF after it');
      rows.push(row);
      row = [];
      state = 'start';
    } else if (state === 'quoted') {
      if (character === '"') state = 'quote';
      else cell += character;
    } else if (state === 'quote' && character === '"') {
      cell += '"';
      state = 'quoted';
    } else if (character === separator) {
      endCell();
      state = 'start';
    } else if (character === '\r') {
      endCell();
      state = 'cr';
    } else if (state === 'start' && character === '"') state = 'quoted';
    else if (state === 'quote' || character === '"' || character === '\n')
      throw new Error(`“${character}” must stand in quotes`);
    else {
      cell += character;
      state = 'plain';
    }
  }
  if (state !== 'start' || row.length > 0) throw new Error('the last row has no end');
  for (const { length } of rows) if (length !== rows[0]?.length) throw new Error('rows of different lengths');
  return rows;
}

/** The text that was meant: without the apostrophe that keeps a spreadsheet from working it out. */
export function meant(cell: string): string {
  return cell.startsWith("'") ? cell.slice(1) : cell;
}
