import type { Modifiers, Tool } from '../../tools/tool';
import type { ModelView } from '../../view/model_view';

/** Passes strokes on the relief to a tool of the page, at the points of the page that are seen there. */
export class ReliefBrush {
  /** Whether a stroke is being drawn, so that the pointer must not turn the model. */
  isDown = false;
  private begun = false;
  /** The last event. Events are handled in order, although picking takes time. */
  private asked: Promise<void> = Promise.resolve();

  constructor(private readonly view: ModelView, private readonly tool: () => Tool) {}

  down(spot: readonly [number, number], keys: Modifiers): void {
    this.isDown = true;
    this.hear(spot, (point) => {
      this.begun = true;
      this.tool().down(point, keys);
    });
  }

  move(spot: readonly [number, number]): void {
    if (this.isDown) this.hear(spot, (point) => this.begun && this.tool().move(point, true));
  }

  up(): void {
    if (!this.isDown) return;
    this.isDown = false;
    this.asked = this.asked.then(() => {
      if (this.begun) this.tool().up([0, 0], { shift: false, alt: false });
      this.begun = false;
    });
  }

  private hear(spot: readonly [number, number], tell: (point: readonly [number, number]) => unknown): void {
    const picked = this.view.pick(...spot);
    this.asked = this.asked.then(async () => {
      const seen = await picked;
      if (seen) tell(seen.at);
    });
  }
}
