// A picture's number as black and white squares in its upper left corner: each bit, and below it its opposite, so that
// what was not drawn whole is not read. Both functions go to a page as their text.

export const numbers = 128; // of seven bits

export function draw(pen, number) {
  const side = pen.canvas.width / 16;
  for (let bit = 0; bit < 7; ++bit) {
    for (const opposite of [0, 1]) {
      pen.fillStyle = ((number >> bit) & 1) === opposite ? '#000' : '#fff';
      pen.fillRect(bit * side, opposite * side, side, side);
    }
  }
}

// Null where none is whole.
export function read(canvas) {
  const side = canvas.width / 16;
  const { data, width } = canvas.getContext('2d').getImageData(0, 0, Math.ceil(7 * side), Math.ceil(2 * side));
  const isWhite = (column, row) => data[4 * (Math.floor((row + 0.5) * side) * width + Math.floor((column + 0.5) * side))] > 127;
  let number = 0;
  for (let bit = 0; bit < 7; ++bit) {
    if (isWhite(bit, 0) === isWhite(bit, 1)) return null;
    if (isWhite(bit, 0)) number += 1 << bit;
  }
  return number;
}
