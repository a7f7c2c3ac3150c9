// A double click is one press. By its second click a button may say something else: "Let the arm go" where it said "Take
// the arm in hand". So that click does nothing, in the parts that command. STOP counts each.

const commanding = ['#want', '#eyes', '#drive', '#head', '#stopped', '#hands-note', '#confirm'];

export function pressOnce() {
  /** @param {MouseEvent} event */
  const take = (event) => {
    const button = event.target instanceof Element && event.target.closest('button:not(.stop)');
    if (event.detail < 2 || !button || !button.closest(commanding.join(', '))) return;
    event.preventDefault();
    event.stopPropagation();
  };
  window.addEventListener('click', take, { capture: true });
}
