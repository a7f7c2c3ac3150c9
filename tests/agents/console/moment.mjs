// node moment.mjs: a time that is typed, of today or of a day before, and what is none.

import { momentIn, timeOf } from '../../../agents/console/page/src/moment_field.js';
import { expect } from './browser.mjs';

const microseconds = (date) => date.getTime() * 1000;
const long = microseconds(new Date(2020, 0, 1));
const at = (typed, date, first = long) => momentIn(typed, date, first);
expect(at('14:03', '2021-03-04').moment === microseconds(new Date(2021, 2, 4, 14, 3, 0)), 'hours and minutes, of a day before');
expect(at(' 9:03:07 ', '2021-03-04').moment === microseconds(new Date(2021, 2, 4, 9, 3, 7)), 'seconds, too');
const now = new Date();
const midnight = new Date(now.getFullYear(), now.getMonth(), now.getDate());
expect(at('00:00:00', '').moment === microseconds(midnight), 'without a day it is of today');
for (const none of ['', '14', '24:00', '14:60', '14:03:60', '14:03:07:09', '-1:00', '14:3'])
  expect(/write a time/.test(at(none, '2021-03-04').wrong), `${none || 'nothing'} is no time`);
const next = `${now.getFullYear() + 1}-01-01`;
expect(/yet to come/.test(at('00:00', next).wrong), 'nor one that is yet to come');
const said = at('14:03', '2021-03-04', microseconds(new Date(2021, 2, 4, 14, 4))).wrong;
expect(said === 'nothing is known from before 2021-03-04 14:04:00', `nor one before all that is known: ${said}`);
expect(/^\d\d:\d\d:\d\d$/.test(timeOf(microseconds(midnight))), "today's times are said without the day");
