/** Tables as pilots have them in spreadsheets, on paper and in files. */
export const sheets = {
  withMotorRow: [
    'Function\tTime\tS1\tS2\tS3',
    'Function 1\t0.30\t62\t44\t70',
    'Function 2\t1.20\t64\t46\t72',
    'Function 3\t4.00\t64\t50\t76',
    'Function 4\t9.80\t66\t52\t78',
    'Motor stop\t10.0\t\t\t',
    'Function 5\t10.10\t70\t30\t78',
    'Function 6\t10.60\t70\t24\t82',
    'Function 7\t11.20\t67\t40\t86',
    'Function 8\t12.50\t65\t54\t88',
    'Function 9\t120.00\t63\t56\t88',
    'DT\t3:00\t63\t95\t88',
  ].join('\n'),
  withStartRow: [
    'Function\tTime (s)\tS1\tS2\tS3',
    'Start\t\t60\t15\t40',
    'F1\t0.30\t61\t16\t41',
    'F2\t1.20\t62\t20\t42',
    'F3\t10.60\t70\t40\t55',
    '',
  ].join('\n'),
  transposed: [
    'Function\tStart\tF1\tF2\tF3\tF4',
    'Time\t0\t0.30\t1.20\t10\t12',
    'S1\t60\t61\t62\t70\t71',
    'S2\t15\t16\t20\t40\t41',
    'S3\t40\t41\t42\t55\t56',
    '',
  ].join('\n'),
  twoColumns: ['Time,S1', '10,60', '13,65', '18,70', ''].join('\n'),
};
