import { getDocumentProxy } from 'unpdf';

/** A page of a PDF file. */
export interface PdfPage {
  /** The width and height in millimetres: “148x210”. */
  readonly size: string;
  /** Its text as it is read, one space between two words. */
  readonly text: string;
}

/** Reads the pages of a PDF file. */
export async function pagesOf(file: Uint8Array): Promise<readonly PdfPage[]> {
  const pdf = await getDocumentProxy(new Uint8Array(file));
  return Promise.all(
    Array.from({ length: pdf.numPages }, async (_, at) => {
      const page = await pdf.getPage(at + 1);
      const { items } = await page.getTextContent();
      const { width, height } = page.getViewport({ scale: 25.4 / 72 });
      const text = items.map((item) => ('str' in item ? item.str + (item.hasEOL ? ' ' : '') : ''));
      return { size: `${Math.round(width)}x${Math.round(height)}`, text: text.join('').replaceAll(/\s+/g, ' ') };
    }),
  );
}
