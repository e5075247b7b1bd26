/** The code under test: asks for a port, sends `T?` and reads a line. */
export async function temperature(serial) {
  const port = await serial.requestPort({ filters: [{ usbVendorId: 0x0403 }] });
  await port.open({ baudRate: 9600 });
  const reader = port.readable.getReader();
  const writer = port.writable.getWriter();
  await writer.write(new TextEncoder().encode('T?\n'));
  let line = '';
  while (!line.endsWith('\n')) {
    const { value } = await reader.read();
    line += new TextDecoder().decode(value);
  }
  reader.releaseLock();
  writer.releaseLock();
  await port.close();
  return Number(line);
}
