import type { CDPSession, Page } from 'playwright-core';

interface TraceEvent {
  name: string;
  pid: number;
  tid: number;
  /** Processor time of the event on its thread, µs. */
  tdur?: number;
  args?: { name?: string };
}

async function collect(session: CDPSession, act: () => Promise<void>): Promise<TraceEvent[]> {
  const events: TraceEvent[] = [];
  session.on('Tracing.dataCollected', ({ value }) => events.push(...(value as unknown as TraceEvent[])));
  await session.send('Tracing.start', {
    transferMode: 'ReportEvents',
    traceConfig: { includedCategories: ['toplevel', 'disabled-by-default-devtools.timeline'] },
  });
  try {
    await act();
  } finally {
    const complete = new Promise((resolve) => session.once('Tracing.tracingComplete', resolve));
    await session.send('Tracing.end');
    await complete;
  }
  return events;
}

/**
 * Returns the processor time of every task, ms, by named thread. Unlike wall time it does not depend on the
 * load of the machine.
 */
async function tasksByThread(page: Page, name: string, act: () => Promise<void>): Promise<number[][]> {
  const session = await page.context().newCDPSession(page);
  const events = await collect(session, act);
  await session.detach();
  const threads = new Map(
    events
      .filter((event) => event.name === 'thread_name' && event.args?.name === name)
      .map(({ pid, tid }) => [`${pid} ${tid}`, [] as number[]]),
  );
  for (const { name: what, pid, tid, tdur } of events)
    if (what.endsWith('RunTask') && tdur !== undefined) threads.get(`${pid} ${tid}`)?.push(tdur / 1000);
  return [...threads.values()];
}

/** Returns the processor time of every task on the page's main thread, ms. */
export async function mainThreadTasks(page: Page, act: () => Promise<void>): Promise<number[]> {
  return (await tasksByThread(page, 'CrRendererMain', act)).flat();
}

/** Returns the processor time of the longest task of each worker, ms, the longest first. */
export async function longestOfWorkers(page: Page, act: () => Promise<void>): Promise<number[]> {
  const workers = await tasksByThread(page, 'DedicatedWorker thread', act);
  return workers.map((tasks) => Math.max(0, ...tasks)).sort((a, b) => b - a);
}
