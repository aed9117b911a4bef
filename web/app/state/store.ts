import { useEffect, useReducer } from 'preact/hooks';

/** Holds a state and calls its listeners after every change. */
export class Store<State extends object> {
  private readonly listeners = new Set<() => void>();

  constructor(private current: State) {}

  get state(): State {
    return this.current;
  }

  set(values: Partial<State>): void {
    const keys = Object.keys(values) as (keyof State)[];
    if (keys.every((key) => this.current[key] === values[key])) return;
    this.current = { ...this.current, ...values };
    for (const listener of [...this.listeners]) listener();
  }

  subscribe(listener: () => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }
}

/** Returns the state of a store. The component is drawn again whenever it changes. */
export function useStore<State extends object>(store: Store<State>): State {
  const [, again] = useReducer((count: number) => count + 1, 0);
  const { state } = store;
  useEffect(() => {
    // The state may have changed between drawing and subscribing.
    if (store.state !== state) again(undefined as never);
    return store.subscribe(() => again(undefined as never));
  }, [store]);
  return state;
}
