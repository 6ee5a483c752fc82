import assert from 'node:assert/strict';
import {test} from 'node:test';
import {bounded, difference_words} from '../../../server/page/src/section/bounds';

const measured = (value: number | null) => ({value, is: 'measured'});

test('a lower bound is said to be one', () => {
  assert.equal(bounded(103.25, 'measured'), '103.3 m');
  assert.equal(bounded(103.25, 'lower-bound'), 'at least 103.3 m');
  assert.equal(bounded(null, null), '–');
});

test('a bound has no difference, and a word says why', () => {
  assert.equal(difference_words(measured(10), measured(25)), '+15 m');
  assert.equal(difference_words(measured(25), measured(10), 's'), '-15 s');
  assert.equal(difference_words(measured(10), {value: 25, is: 'lower-bound'}), 'unknown: a lower bound');
  assert.equal(difference_words({value: 10, is: 'lower-bound'}, measured(25)), 'unknown: a lower bound');
  assert.equal(difference_words(measured(10), measured(null)), '–');
});
