// Talk with the server: JSON, problems, tokens, uploads. Every address is beside this page.

export interface Fault {
  pointer: string;
  detail: string;
}

/** What the server refused, or why there was no answer (status 0). */
export class Problem extends Error {
  constructor(readonly status: number, message: string, readonly faults: Fault[] = []) {
    super(message);
  }
}

const kept_as = 'leda-token';
const base = new URL('.', document.baseURI);

let ask_for_token: (refused: boolean) => Promise<string> = () => Promise.resolve('');
let tell_connection: (there: boolean) => void = () => undefined;

/** Who asks the user for a token, and who is told whether the server answers. */
export function connect(token: typeof ask_for_token, connection: typeof tell_connection): void {
  ask_for_token = token;
  tell_connection = connection;
}

export function address(path: string): string {
  return new URL(path, base).href;
}

function token(): string {
  return sessionStorage.getItem(kept_as) ?? '';
}

export function forget_token(): void {
  sessionStorage.removeItem(kept_as);
}

function with_token(headers: HeadersInit | undefined): Headers {
  const all = new Headers(headers);
  if (token()) all.set('Authorization', `Bearer ${token()}`);
  return all;
}

export function problem_of(status: number, text: string): Problem {
  try {
    const document = JSON.parse(text) as {detail?: string; title?: string; errors?: Fault[]};
    return new Problem(status, document.detail ?? document.title ?? text, document.errors ?? []);
  } catch {
    return new Problem(status, text || `HTTP ${status}`);
  }
}

/** One asks for a token, the others wait for the same answer. */
let asking: Promise<string> | null = null;

async function new_token(): Promise<void> {
  const refused = token() !== '';
  asking ??= ask_for_token(refused).finally(() => (asking = null));
  sessionStorage.setItem(kept_as, await asking);
}

/** The answer, once the server let us in. @throws Problem */
export async function request(path: string, init: RequestInit = {}): Promise<Response> {
  for (;;) {
    const used = token();
    let answer: Response;
    try {
      answer = await fetch(address(path), {...init, headers: with_token(init.headers)});
    } catch (error) {
      if (init.signal?.aborted) throw error;
      tell_connection(false);
      throw new Problem(0, 'no answer');
    }
    tell_connection(true);
    if (answer.status === 401) {
      // Another request may have got a token meanwhile.
      if (token() === used) await new_token();
      continue;
    }
    if (!answer.ok) throw problem_of(answer.status, await answer.text());
    return answer;
  }
}

export async function get<T>(path: string): Promise<T> {
  return (await request(path, {headers: {Accept: 'application/json'}})).json() as Promise<T>;
}

export async function text(path: string): Promise<string> {
  return (await request(path, {headers: {Accept: '*/*'}})).text();
}

export async function blob(path: string): Promise<Blob> {
  return (await request(path, {headers: {Accept: '*/*'}})).blob();
}

export async function send<T>(method: string, path: string, body?: unknown): Promise<T> {
  const answer = await request(path, {
    method,
    headers: {'Content-Type': 'application/json', Accept: 'application/json'},
    body: body === undefined ? undefined : JSON.stringify(body),
  });
  return (answer.status === 204 ? undefined : await answer.json()) as T;
}

/** A file as the body, with its progress from 0 to 1. @throws Problem */
export function upload<T>(path: string, file: Blob, progress: (share: number) => void): Promise<T> {
  return new Promise((done, failed) => {
    const call = new XMLHttpRequest();
    call.open('POST', address(path));
    call.setRequestHeader('Content-Type', 'image/tiff');
    if (token()) call.setRequestHeader('Authorization', `Bearer ${token()}`);
    call.upload.onprogress = (event) => progress(event.loaded / Math.max(event.total, 1));
    call.onload = () => {
      if (call.status >= 200 && call.status < 300) done(JSON.parse(call.responseText) as T);
      else failed(problem_of(call.status, call.responseText));
    };
    call.onerror = () => failed(new Problem(0, 'no answer'));
    call.send(file);
  });
}
