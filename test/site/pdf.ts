import { inflateSync } from 'node:zlib';

/** A page of a PDF file that Chromium has made. */
export interface PdfPage {
  /** The width and height in millimetres: “148x210”. */
  readonly size: string;
  /** Its letters in the order in which they are drawn, without spaces: those are only distances. */
  readonly text: string;
}

/** Reads the pages of a PDF file as Chromium makes them: every object stands in it by itself, each font has a map. */
export function pagesOf(file: Uint8Array): readonly PdfPage[] {
  const text = Buffer.from(file).toString('latin1');
  const objects = new Map(
    [...text.matchAll(/(?:^|\n)(\d+) 0 obj\s([\s\S]*?)\sendobj/g)].map(([, id = '', body = '']) => [id, body]),
  );
  const at = (body: string, key: string): string => {
    const id = new RegExp(`/${key}\\s*\\[?\\s*(\\d+) 0 R`).exec(body)?.[1];
    return objects.get(id ?? '') ?? '';
  };
  const fonts = new Map<string, Font>();
  const fontOf = (id: string): Font => {
    const font = fonts.get(id) ?? fontIn(unpacked(at(objects.get(id) ?? '', 'ToUnicode')));
    fonts.set(id, font);
    return font;
  };
  return [...objects.values()]
    .filter((body) => /\/Type\s*\/Page\b/.test(body))
    .map((body) => {
      const box = /\/MediaBox\s*\[0 0 ([\d.]+) ([\d.]+)\]/.exec(body)?.slice(1) ?? [];
      const named = new Map([...body.matchAll(/\/(F\d+) (\d+) 0 R/g)].map(([, name = '', id = '']) => [name, id]));
      let font: Font | null = null;
      let text = '';
      for (const [, name, codes = ''] of unpacked(at(body, 'Contents')).matchAll(
        /\/(F\d+) [\d.]+ Tf|<([\dA-F]+)> Tj/gi,
      )) {
        if (name !== undefined) font = fontOf(named.get(name) ?? '');
        else if (font) text += font.read(codes);
      }
      return {
        size: box.map((points) => Math.round((Number(points) / 72) * 25.4)).join('x'),
        text: text.replace(/\s/g, ''),
      };
    });
}

/** The content of a packed stream. */
function unpacked(body: string): string {
  const stream = /stream\r?\n([\s\S]*?)\r?\n?endstream/.exec(body)?.[1] ?? '';
  return stream === '' ? '' : inflateSync(Buffer.from(stream, 'latin1')).toString('latin1');
}

interface Font {
  /** @param codes of glyphs, in hexadecimal. */
  readonly read: (codes: string) => string;
}

/** A font by the map of its glyphs. */
function fontIn(map: string): Font {
  const digits = /begincodespacerange\s*<(\w+)>/.exec(map)?.[1]?.length ?? 4;
  const letters = new Map<number, string>();
  const numberOf = (hex: string): number => Number.parseInt(hex, 16);
  for (const [, part = ''] of map.matchAll(/beginbfchar([\s\S]*?)endbfchar/g)) {
    for (const [, glyph = '', to = ''] of part.matchAll(/<(\w+)> <(\w+)>/g)) {
      letters.set(numberOf(glyph), String.fromCharCode(...(to.match(/..../g) ?? []).map(numberOf)));
    }
  }
  for (const [, part = ''] of map.matchAll(/beginbfrange([\s\S]*?)endbfrange/g)) {
    for (const [, from = '', until = '', to = ''] of part.matchAll(/<(\w+)> <(\w+)> <(\w+)>/g)) {
      const first = numberOf(from);
      for (let glyph = first; glyph <= numberOf(until); glyph++) {
        letters.set(glyph, String.fromCharCode(numberOf(to) + glyph - first));
      }
    }
  }
  const each = new RegExp(`.{${digits}}`, 'g');
  return { read: (codes) => (codes.match(each) ?? []).map((code) => letters.get(numberOf(code)) ?? '').join('') };
}
