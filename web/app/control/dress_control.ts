import { shownContourWidth } from '../../document/document';
import { type Engine, EngineStopped } from '../../engine/engine';
import { isFailure } from '../../engine/messages';
import { lookOf, vectorSide } from '../../view/painted_drawing';
import { type BuildControl, fullTolerance } from './build_control';
import { type DressedRelief, dressedIn, type Editor } from '../state/editor';
import { smallPicture } from '../files/pictures';

/** A relief is dressed once it has been the current one for this long, ms. */
const rest = 500;

/**
 * Shows the full relief as exported files contain it once the hand rests: its contours turn with it, and no
 * paper colour shows at rims.
 */
export class DressControl {
  private waiting = false;
  private tried: object | null = null;

  /** `engine` is the one that builds full reliefs. */
  constructor(
    private readonly editor: Editor,
    private readonly engine: Engine,
    private readonly control: BuildControl,
  ) {
    editor.subscribe(() => void this.follow());
  }

  private async follow(): Promise<void> {
    const { relief } = this.editor.state;
    if (this.waiting || !relief || !this.isWanted()) return;
    this.waiting = true;
    await new Promise((resolve) => setTimeout(resolve, rest));
    const look = lookOf(this.editor.document, this.editor.state.picture);
    const contourWidth = shownContourWidth(this.editor.document.settings);
    const dressed = relief === this.editor.state.relief && this.isWanted() ? await this.dress({ relief, look, contourWidth }) : null;
    this.waiting = false;
    if (dressed) this.editor.set({ dressed });
    else void this.follow();
  }

  private isWanted(): boolean {
    const { build, preview, field, relief, picture } = this.editor.state;
    const isBuilt = build.phase === 'idle' && !preview && field === 'relief' && this.control.isUpToDate();
    const dressed = dressedIn(this.editor.state, lookOf(this.editor.document, picture));
    return isBuilt && relief !== this.tried && dressed?.contourWidth !== shownContourWidth(this.editor.document.settings);
  }

  /** Returns the dressed relief, or null if it is outdated or the engine has other work by then. */
  private async dress(of: Pick<DressedRelief, 'relief' | 'look' | 'contourWidth'>): Promise<DressedRelief | null> {
    try {
      const drawing = await smallPicture(this.editor.document, this.editor.state.picture, vectorSide);
      if (!this.isWanted()) return null;
      const made = await this.engine.dress(fullTolerance, of.contourWidth, drawing);
      if (!isFailure(made)) return { ...of, ...made };
      this.tried = of.relief;
    } catch (error) {
      if (!(error instanceof EngineStopped)) throw error;
      this.tried = of.relief;
    }
    return null;
  }
}
