import { type Engine, EngineStopped } from '../engine/engine';
import { isFailure } from '../engine/messages';
import { lookOf, vectorSide } from '../view/painted_drawing';
import { type BuildControl, fullTolerance } from './build_control';
import { type DressedRelief, type Editor, isDressed } from './editor';
import { smallPicture } from './pictures';

/** Shows the full relief as its files hold it when the hand rests: ink thin at rims, no paper on them. */
export class DressControl {
  private dressing = false;
  private tried: object | null = null;

  /** `engine`: the one that holds the full relief. */
  constructor(
    private readonly editor: Editor,
    private readonly engine: Engine,
    private readonly control: BuildControl,
  ) {
    editor.subscribe(() => void this.follow());
  }

  private async follow(): Promise<void> {
    const { relief } = this.editor.state;
    const look = lookOf(this.editor.document, this.editor.state.picture);
    if (this.dressing || !relief || !this.isWanted() || isDressed(this.editor.state, look)) return;
    this.dressing = true;
    const dressed = await this.dress({ relief, look }).finally(() => {
      this.dressing = false;
    });
    if (dressed) this.editor.set({ dressed });
  }

  private isWanted(): boolean {
    const { build, preview, field, relief } = this.editor.state;
    return build.phase === 'idle' && !preview && field === 'relief' && this.control.isUpToDate() && relief !== this.tried;
  }

  /** Null where the engine has something else to do by then. */
  private async dress(of: Pick<DressedRelief, 'relief' | 'look'>): Promise<DressedRelief | null> {
    try {
      const drawing = await smallPicture(this.editor.document, this.editor.state.picture, vectorSide);
      if (!this.isWanted()) return null;
      const made = await this.engine.dress(fullTolerance, drawing);
      if (!isFailure(made)) return { ...of, ...made };
      this.tried = of.relief;
    } catch (error) {
      if (!(error instanceof EngineStopped)) throw error;
      this.tried = of.relief;
    }
    return null;
  }
}
