// What the page carries beside its text: the comparison, the scenes and their buffers, pictures.

/** The parsed content of a script element, or null where the page has none. */
export function read_json(id) {
  const holder = document.getElementById(id);
  return holder === null ? null : JSON.parse(holder.textContent);
}

function bytes_of_base64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/** @returns {ArrayBuffer} the decoded bytes of one scene, which elements of one class hold; nothing is kept of it here */
export function decoded_buffer(name) {
  const pieces = Array.from(document.getElementsByClassName(name), (holder) => holder.textContent);
  return bytes_of_base64(pieces.join('')).buffer;
}

/** @returns {string} functions in GLSL; a page that shows wires has them */
export const wire_functions = () => document.getElementById('wire-functions').textContent;

/** @returns {string} a picture that a technique attached, as an address */
export const picture = (number) => `data:image/png;base64,${document.getElementById(`picture-${number}`).textContent}`;
