// Follows a job by its Server-Sent Events. EventSource can send no token, so the stream is read here.

import {Problem, get, request} from './api';
import type {Job} from './types';

export interface Parsed {
  id: string;
  data: string;
}

/** Takes whole events off the front of what has arrived; the rest is left. */
export function take_events(buffer: string): {events: Parsed[]; rest: string} {
  const events: Parsed[] = [];
  const blocks = buffer.split('\n\n');
  const rest = blocks.pop() ?? '';
  for (const block of blocks) {
    const event: Parsed = {id: '', data: ''};
    for (const line of block.split('\n')) {
      if (line.startsWith('id: ')) event.id = line.slice(4);
      if (line.startsWith('data: ')) event.data += line.slice(6);
    }
    if (event.data) events.push(event);
  }
  return {events, rest};
}

export function is_finished(job: Job): boolean {
  return job.status !== 'accepted' && job.status !== 'running';
}

const pause = (ms: number) => new Promise((done) => setTimeout(done, ms));

/** One stream from its start to its end. @return the last status heard and the id of its event */
async function read_stream(id: string, last_id: string, signal: AbortSignal,
                           tell: (job: Job) => void): Promise<{job: Job | null; last_id: string}> {
  const headers: Record<string, string> = {Accept: 'text/event-stream'};
  if (last_id) headers['Last-Event-ID'] = last_id;
  const answer = await request(`jobs/${id}/events`, {headers, signal});
  const reader = answer.body!.pipeThrough(new TextDecoderStream()).getReader();
  let buffer = '';
  let job: Job | null = null;
  for (;;) {
    const {done, value} = await reader.read();
    if (done) return {job, last_id};
    const taken = take_events(buffer + value);
    buffer = taken.rest;
    for (const event of taken.events) {
      last_id = event.id || last_id;
      job = JSON.parse(event.data) as Job;
      tell(job);
    }
  }
}

/** Tells every new status until the job has finished. @return how to stop listening */
export function follow(id: string, tell: (job: Job) => void): () => void {
  const stopped = new AbortController();
  const listen = async () => {
    let last_id = '';
    while (!stopped.signal.aborted) {
      try {
        const heard = await read_stream(id, last_id, stopped.signal, tell);
        last_id = heard.last_id;
        if (heard.job && is_finished(heard.job)) return;
      } catch (error) {
        if (stopped.signal.aborted) return;
        if (error instanceof Problem && error.status === 404) return;
        // Too many streams are open: ask instead.
        if (error instanceof Problem && error.status === 503) {
          const job = await get<Job>(`jobs/${id}`).catch(() => null);
          if (job) tell(job);
          if (job && is_finished(job)) return;
        }
      }
      await pause(1500);
    }
  };
  void listen();
  return () => stopped.abort();
}
