// What plays, without the machine's clock: on a busy one, whole films pass between two looks.

/** Takes the page's frames from the browser: `show(milliseconds)` gives it those of so long, 16 ms apart. */
export async function hold_frames(page) {
  const held = await page.evaluateHandle(() => {
    const { requestAnimationFrame: request, cancelAnimationFrame: cancel } = window;
    const asked = new Map(); // frames that the page waits for
    let last_number = 0; // going down: no browser gives such
    let now = 0;
    window.requestAnimationFrame = (call) => {
      const number = --last_number;
      asked.set(number, call);
      return number;
    };
    window.cancelAnimationFrame = (number) => asked.delete(number) || cancel.call(window, number);
    return {
      show(milliseconds) {
        for (const end = now + milliseconds; now <= end; now += 16) {
          const calls = [...asked.values()];
          asked.clear();
          for (const call of calls) call(now);
        }
      },
      let_go() {
        Object.assign(window, { requestAnimationFrame: request, cancelAnimationFrame: cancel });
        for (const call of asked.values()) request.call(window, call);
      },
    };
  });
  return {
    show: (milliseconds) => held.evaluate(({ show }, some) => show(some), milliseconds),
    let_go: () => held.evaluate(({ let_go }) => let_go()),
  };
}

/** Presses a play button, gives the page its frames, and presses it again. */
export async function play_for(page, button, milliseconds) {
  const frames = await hold_frames(page);
  await button.press('Enter');
  await frames.show(milliseconds);
  await button.press('Enter');
  await frames.let_go();
}
