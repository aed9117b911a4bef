import { type Engine, EngineStopped } from '../../engine/engine';
import type { BuildControl } from './build_control';
import type { Editor } from '../state/editor';
import { smallPicture } from '../files/pictures';
import { solidOptions } from '../state/print_choice';
import { lookOf } from '../../view/painted_drawing';

/** Longest side of the texture of the solid shown, px. */
const shownSide = 1024;
/** The solid is made once nothing has changed for this long, ms. */
const rest = 120;

/** Shows the solid that would be printed while the print panel is open. */
export class PrintControl {
  private of: readonly unknown[] = [];
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly editor: Editor,
    private readonly engine: Engine,
    private readonly control: BuildControl,
  ) {
    editor.subscribe(() => this.follow());
  }

  private follow(): void {
    const { panel, print, picture, relief, history } = this.editor.state;
    const open = panel === 'print' && history.document.parts.length > 0;
    const of = open ? [print, relief, history.document.settings.sizeMm, ...lookOf(history.document, picture)] : [];
    if (of.length === this.of.length && of.every((value, i) => value === this.of[i])) return;
    this.of = of;
    clearTimeout(this.timer);
    if (open) this.timer = setTimeout(() => void this.make(of), rest);
    else this.editor.set({ solid: null });
  }

  private async make(of: readonly unknown[]): Promise<void> {
    try {
      await this.control.settle();
      const { document, state } = this.editor;
      const drawing = await smallPicture(document, state.picture, shownSide);
      const made = await this.engine.solid(solidOptions(state.print, document.settings.sizeMm), drawing);
      if (this.of === of) this.editor.set({ solid: made });
    } catch (error) {
      // The relief's pane already shows why there is none.
      if (!(error instanceof EngineStopped) && this.of === of) this.editor.set({ solid: null });
    }
  }
}
