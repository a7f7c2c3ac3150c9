// A picture's number as black and white squares in its upper left corner: each bit, and below it its opposite, so that
// what was not drawn whole is not read.

export const numbers = 1024;

// As functions of a page: they go there as their text.
export const readable = {
  draw: (pen, number) => {
    const side = 24;
    for (let bit = 0; bit < 10; ++bit) {
      for (const opposite of [0, 1]) {
        pen.fillStyle = ((number >> bit) & 1) === opposite ? '#000' : '#fff';
        pen.fillRect(bit * side, opposite * side, side, side);
      }
    }
  },
  // Null where none is whole.
  read: (canvas) => {
    const side = (24 * canvas.width) / 320;
    const { data, width } = canvas.getContext('2d').getImageData(0, 0, Math.ceil(10 * side), Math.ceil(2 * side));
    const isWhite = (column, row) => data[4 * (Math.floor((row + 0.5) * side) * width + Math.floor((column + 0.5) * side))] > 127;
    let number = 0;
    for (let bit = 0; bit < 10; ++bit) {
      if (isWhite(bit, 0) === isWhite(bit, 1)) return null;
      if (isWhite(bit, 0)) number += 1 << bit;
    }
    return number;
  },
};
