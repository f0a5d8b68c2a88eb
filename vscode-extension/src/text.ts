/** Bytes as text, read as `deburr check` reads them: UTF-8, else Windows-1252, so that it never fails. Knows no editor. */

export function decoded(bytes: Uint8Array): string {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    return new TextDecoder('windows-1252').decode(bytes);
  }
}
