// What plays, without the machine's clock: on a busy one, whole films pass between two looks.

/** Presses a play button, lets `milliseconds` of the page's own time pass in frames of 16, and presses it again. */
export async function play_for(page, button, milliseconds) {
  await page.clock.install();
  await page.clock.pauseAt(Date.now() + 1000);
  await button.press('Enter');
  await page.clock.runFor(milliseconds);
  await button.press('Enter');
  await page.clock.resume();
}
