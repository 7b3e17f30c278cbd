// What plays, without the machine's clock: on a busy one, whole films pass between two looks.

/** Presses a play button, gives the page its frames, 16 ms apart, and presses it again. */
export async function play_for(page, button, milliseconds) {
  const held = await page.evaluateHandle(() => {
    const { requestAnimationFrame: request, cancelAnimationFrame: cancel } = window;
    const asked = new Map(); // frames that the page waits for
    let last_number = 0; // going down: no browser gives such
    window.requestAnimationFrame = (call) => {
      const number = --last_number;
      asked.set(number, call);
      return number;
    };
    window.cancelAnimationFrame = (number) => asked.delete(number) || cancel.call(window, number);
    return {
      show(time) {
        const calls = [...asked.values()];
        asked.clear();
        for (const call of calls) call(time);
      },
      let_go() {
        Object.assign(window, { requestAnimationFrame: request, cancelAnimationFrame: cancel });
        for (const call of asked.values()) request.call(window, call);
      },
    };
  });
  await button.press('Enter');
  await held.evaluate(({ show }, last) => {
    for (let time = 0; time <= last; time += 16) show(time);
  }, milliseconds);
  await button.press('Enter');
  await held.evaluate(({ let_go }) => let_go());
}
